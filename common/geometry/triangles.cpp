#include "common/geometry/triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/geometry/shape.hpp"

namespace cosurge {
namespace {

using Point = std::array<double, 3>;
using Cell = std::array<long, 3>;

/// The points so far, in cells of the size within which points are merged.
class Points {
 public:
  explicit Points(double tolerance) : tolerance_(tolerance) {}

  /// A point that was seen within the tolerance of x, else x.
  Point find_or_add(const Point& x) {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) cell[k] = std::lround(std::floor(x[k] / tolerance_));
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto found = seen_.find(Cell{cell[0] + i, cell[1] + j, cell[2] + k});
          if (found != seen_.end() && near(found->second, x)) return found->second;
        }
    seen_.emplace(cell, x);
    return x;
  }

 private:
  bool near(const Point& a, const Point& b) const {
    return std::abs(a[0] - b[0]) <= tolerance_ && std::abs(a[1] - b[1]) <= tolerance_ &&
           std::abs(a[2] - b[2]) <= tolerance_;
  }

  double tolerance_;
  std::map<Cell, Point> seen_;
};

double size_of(const std::vector<double>& corners) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = corners[axis], high = corners[axis];
    for (std::size_t k = axis; k < corners.size(); k += 3) {
      low = std::min(low, corners[k]);
      high = std::max(high, corners[k]);
    }
    size = std::max(size, high - low);
  }
  return size;
}

using Edge = std::pair<Point, Point>;

Point point_of(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

std::vector<Triangle> triangles_of(const std::vector<double>& corners) {
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t + 9 <= corners.size(); t += 9) {
    const auto corner = [&](std::size_t c) {
      return Vec<3>(Eigen::Map<const Vec<3>>(corners.data() + t + 3 * c));
    };
    triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return triangles;
}

std::vector<double> corners_of(const std::vector<Triangle>& triangles) {
  std::vector<double> corners;
  for (const Triangle& triangle : triangles)
    for (const Vec<3>& corner : triangle) corners.insert(corners.end(), corner.data(), corner.data() + 3);
  return corners;
}

/// A triangle's side, from the smaller of its ends, and whether the triangle passes it that way.
std::pair<Edge, bool> side_of(const Triangle& triangle, std::size_t k) {
  const Point from = point_of(triangle[k]), to = point_of(triangle[(k + 1) % 3]);
  return from < to ? std::pair{Edge{from, to}, true} : std::pair{Edge{to, from}, false};
}

/// A surface whose parts are ordered one after the other.
class Surface {
 public:
  explicit Surface(std::vector<Triangle> triangles)
      : triangles_(std::move(triangles)), part_(triangles_.size(), none) {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) beside_[side_of(triangles_[t], k).first].push_back(t);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (part_[t] == none) order_part(t);
  }

  std::vector<Triangle> outwards() {
    for (const std::vector<std::size_t>& part : parts_)
      if (is_closed(part) && volume(part) < 0 && !within_another(part))
        for (const std::size_t t : part) turn(t);
    return triangles_;
  }

 private:
  static constexpr int none = -1;

  void turn(std::size_t t) { std::swap(triangles_[t][1], triangles_[t][2]); }

  /// Goes from the triangle `first` across edges of two triangles; most of the part stays as it was.
  void order_part(std::size_t first) {
    const int number = static_cast<int>(parts_.size());
    std::vector<std::size_t> part = {first}, turned;
    part_[first] = number;
    for (std::size_t n = 0; n < part.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [edge, forward] = side_of(triangles_[part[n]], k);
        const std::vector<std::size_t>& both = beside_.at(edge);
        if (both.size() != 2) continue;
        const std::size_t other = both[both[0] == part[n] ? 1 : 0];
        if (part_[other] != none) continue;
        part_[other] = number;
        part.push_back(other);
        if (passes(other, edge) != forward) continue;
        turn(other);
        turned.push_back(other);
      }
    }
    if (2 * turned.size() > part.size())
      for (const std::size_t t : part) turn(t);
    parts_.push_back(std::move(part));
  }

  bool passes(std::size_t t, const Edge& edge) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto [side, forward] = side_of(triangles_[t], k); side == edge) return forward;
    return false;
  }

  /// Parts that touch at a common face are separated there, as they should be.
  bool is_closed(const std::vector<std::size_t>& part) const {
    std::vector<Triangle> own;
    for (const std::size_t t : part) own.push_back(triangles_[t]);
    return is_oriented(own);
  }

  double volume(const std::vector<std::size_t>& part) const {
    const Vec<3> origin = triangles_.front()[0];
    double sum = 0;
    for (const std::size_t t : part) {
      const auto& [a, b, c] = triangles_[t];
      sum += (a - origin).dot((b - origin).cross(c - origin)) / 6;
    }
    return sum;
  }

  /// Whether the part's corners, or some of many, all lie in the others.
  bool within_another(const std::vector<std::size_t>& part) const {
    constexpr std::size_t enough = 50;
    std::vector<Vec<3>> rest;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (part_[t] != part_[part.front()])
        rest.insert(rest.end(), triangles_[t].begin(), triangles_[t].end());
    if (rest.empty()) return false;
    const Shape<3> others(rest);
    for (std::size_t n = 0; n < part.size(); n += 1 + part.size() / enough)
      for (const Vec<3>& corner : triangles_[part[n]])
        if (!others.contains(corner)) return false;
    return true;
  }

  std::vector<Triangle> triangles_;
  std::vector<int> part_;  // part of each triangle
  std::vector<std::vector<std::size_t>> parts_;
  std::map<Edge, std::vector<std::size_t>> beside_;  // triangles at each edge
};

}  // namespace

bool is_oriented(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<Edge, int>> sides;
  for (const Triangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [edge, forward] = side_of(triangle, k);
      if (edge.first != edge.second) sides.emplace_back(edge, forward ? 1 : -1);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t k = 0; k < sides.size();) {
    int balance = 0;
    const Edge edge = sides[k].first;
    for (; k < sides.size() && sides[k].first == edge; ++k) balance += sides[k].second;
    if (balance != 0) return false;
  }
  return true;
}

std::vector<double> orient(const std::vector<double>& corners) {
  if (corners.empty()) return corners;
  return corners_of(Surface(triangles_of(corners)).outwards());
}

std::vector<double> weld(const std::vector<double>& corners) {
  constexpr double same = 1e-6;
  const double size = corners.empty() ? 0 : size_of(corners);
  if (!(size > 0)) return corners;
  Points points(same * size);
  std::vector<double> welded;
  for (std::size_t t = 0; t + 9 <= corners.size(); t += 9) {
    std::array<Point, 3> triangle;
    for (std::size_t c = 0; c < 3; ++c)
      triangle[c] = points.find_or_add({corners[t + 3 * c], corners[t + 3 * c + 1], corners[t + 3 * c + 2]});
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    for (const Point& corner : triangle) welded.insert(welded.end(), corner.begin(), corner.end());
  }
  return welded;
}

}  // namespace cosurge
