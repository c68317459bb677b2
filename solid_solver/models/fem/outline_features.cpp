#include "solid_solver/models/fem/outline_features.hpp"

#include <Eigen/Eigenvalues>
#include <map>
#include <numeric>

namespace cosurge::fem {
namespace {

constexpr double spread = 0.03;  // least share of the normals around a corner in any direction
constexpr double sharp = 0.86;   // largest cosine of the angle between normals at a sharp edge, and of the
                                 // turn of a crease at a corner
constexpr std::size_t parts_of_ring = 4;

/// Whether the unit normals n around a point, given by the sum of n (x) n, span the space.
template <int dim>
bool spans(const Mat<dim>& normals) {
  return Eigen::SelfAdjointEigenSolver<Mat<dim>>(normals).eigenvalues()[0] > spread * normals.trace();
}

template <int dim>
Mat<dim> share_of(const Vec<dim>& normal) {
  return normal.isZero(0) ? Mat<dim>::Zero() : Mat<dim>(normal * normal.transpose() / normal.squaredNorm());
}

std::vector<Vec<2>> corners_of_polygon(const Shape<2>& shape) {
  std::map<std::array<double, 2>, Mat<2>> normals;
  for (const auto& side : shape.facets())
    for (const Vec<2>& x : side)
      normals.try_emplace({x[0], x[1]}, Mat<2>::Zero()).first->second += share_of<2>(normal_of(side));
  std::vector<Vec<2>> corners;
  for (const auto& [x, around] : normals)
    if (spans<2>(around)) corners.emplace_back(x[0], x[1]);
  return corners;
}

/// The triangles of a closed surface by their points, their patches, and the sharp edges between these.
class Surface {
 public:
  using Point = std::size_t;

  explicit Surface(const std::vector<Shape<3>::Facet>& facets) : patch_(facets.size()) {
    std::map<std::array<double, 3>, Point> points;
    for (const auto& facet : facets)
      for (const Vec<3>& x : facet) points.try_emplace({x[0], x[1], x[2]});
    for (auto& [x, point] : points) {
      point = x_.size();
      x_.emplace_back(x[0], x[1], x[2]);
    }
    neighbours_.resize(x_.size());
    normals_.assign(x_.size(), Mat<3>::Zero());
    std::map<std::pair<Point, Point>, std::vector<std::size_t>> edges;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec<3>&a = facets[f][k], &b = facets[f][(k + 1) % 3];
        const Point from = points.at({a[0], a[1], a[2]}), to = points.at({b[0], b[1], b[2]});
        normals_[from] += share_of<3>(normal_of(facets[f]));
        if (from != to) edges[std::minmax(from, to)].push_back(f);
      }
    }
    std::iota(patch_.begin(), patch_.end(), 0);
    for (const auto& [edge, sides] : edges) part(facets, edge, sides);
  }

  const std::vector<Vec<3>>& x() const { return x_; }

  /// Points that sharp edges join to a point, in ascending order.
  const std::vector<Point>& neighbours(Point p) const { return neighbours_[p]; }

  /// Whether normals around a point span the space, as at the tip of a cone.
  bool is_tip(Point p) const { return spans<3>(normals_[p]); }

  /// Facets of each patch.
  std::vector<Shape<3>> patches(const std::vector<Shape<3>::Facet>& facets) {
    std::map<std::size_t, std::vector<Vec<3>>> outlines;
    for (std::size_t f = 0; f < facets.size(); ++f)
      outlines[root(f)].insert(outlines[root(f)].end(), facets[f].begin(), facets[f].end());
    std::vector<Shape<3>> all;
    for (const auto& [first, outline] : outlines) all.emplace_back(outline);
    return all;
  }

 private:
  void part(const std::vector<Shape<3>::Facet>& facets, const std::pair<Point, Point>& edge,
            const std::vector<std::size_t>& sides) {
    bool smooth = sides.size() == 2;
    if (smooth) {
      const Vec<3> one = normal_of(facets[sides[0]]), other = normal_of(facets[sides[1]]);
      smooth = one.dot(other) >= sharp * one.norm() * other.norm();
    }
    if (smooth) {
      const auto [low, high] = std::minmax({root(sides[0]), root(sides[1])});
      patch_[high] = low;
    } else {
      neighbours_[edge.first].push_back(edge.second);
      neighbours_[edge.second].push_back(edge.first);
    }
  }

  std::size_t root(std::size_t facet) const {
    while (patch_[facet] != facet) facet = patch_[facet];
    return facet;
  }

  std::vector<Vec<3>> x_;
  std::vector<Mat<3>> normals_;  // around each point
  std::vector<std::vector<Point>> neighbours_;
  std::vector<std::size_t> patch_;  // towards the first facet of the patch
};

/// Follows the sharp edges from corner to corner, each once.
class Tracing {
 public:
  using Point = Surface::Point;

  explicit Tracing(const Surface& surface) : surface_(surface) {
    const std::size_t points = surface.x().size();
    number_.assign(points, none);
    seen_.resize(points);
    for (Point p = 0; p < points; ++p) {
      seen_[p].assign(surface.neighbours(p).size(), 0);
      if (is_corner(p)) add_corner(p);
    }
    const std::vector<Point> found = corners_;
    for (const Point p : found) trace_from(p);
    for (Point p = 0; p < points; ++p) trace_from(p);  // the remaining ones are closed curves
  }

  const std::vector<Point>& corners() const { return corners_; }
  std::vector<Crease> creases() const {
    std::vector<Crease> all;
    for (const std::vector<Point>& chain : chains_) {
      Crease& crease = all.emplace_back();
      crease.ends = {number_[chain.front()], number_[chain.back()]};
      for (const Point p : chain) crease.points.push_back(surface_.x()[p]);
    }
    return all;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool is_corner(Point p) const {
    const std::vector<Point>& next = surface_.neighbours(p);
    if (surface_.is_tip(p)) return true;
    if (next.size() != 2) return !next.empty();
    const Vec<3> in = surface_.x()[p] - surface_.x()[next[0]], out = surface_.x()[next[1]] - surface_.x()[p];
    return in.dot(out) < sharp * in.norm() * out.norm();
  }

  void add_corner(Point p) {
    if (number_[p] != none) return;
    number_[p] = corners_.size();
    corners_.push_back(p);
  }

  void trace_from(Point start) {
    for (std::size_t k = 0; k < surface_.neighbours(start).size(); ++k) {
      if (seen_[start][k]) continue;
      std::vector<Point> chain = {start};
      std::size_t way = k;
      do {
        const Point from = chain.back(), to = surface_.neighbours(from)[way];
        seen_[from][way] = 1;
        chain.push_back(to);
        const std::vector<Point>& next = surface_.neighbours(to);
        const auto back = static_cast<std::size_t>(std::find(next.begin(), next.end(), from) - next.begin());
        seen_[to][back] = 1;
        way = 1 - std::min<std::size_t>(back, 1);
      } while (number_[chain.back()] == none && chain.back() != start);
      keep(chain);
    }
  }

  void keep(const std::vector<Point>& chain) {
    const std::size_t edges = chain.size() - 1;
    const std::size_t parts = chain.front() == chain.back() ? std::min(parts_of_ring, edges) : 1;
    for (std::size_t part = 0; part < parts; ++part) {
      const auto first = static_cast<std::ptrdiff_t>(part * edges / parts),
                 last = static_cast<std::ptrdiff_t>((part + 1) * edges / parts);
      chains_.emplace_back(chain.begin() + first, chain.begin() + last + 1);
      add_corner(chains_.back().front());
      add_corner(chains_.back().back());
    }
  }

  const Surface& surface_;
  std::vector<Point> corners_;
  std::vector<std::size_t> number_;      // index of each point among the corners
  std::vector<std::vector<char>> seen_;  // visited sharp edges of each point
  std::vector<std::vector<Point>> chains_;
};

}  // namespace

double Crease::length() const {
  double sum = 0;
  for (std::size_t k = 1; k < points.size(); ++k) sum += (points[k] - points[k - 1]).norm();
  return sum;
}

Vec<3> Crease::at(double share) const {
  double left = share * length();
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double edge = (points[k] - points[k - 1]).norm();
    if (left <= edge) return points[k - 1] + left / edge * (points[k] - points[k - 1]);
    left -= edge;
  }
  return points.back();
}

double Crease::distance(const Vec<3>& x) const {
  double least = (x - points.front()).norm();
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec<3> edge = points[k] - points[k - 1];
    const double share = std::clamp((x - points[k - 1]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (x - points[k - 1] - share * edge).norm());
  }
  return least;
}

template <>
OutlineFeatures<2>::OutlineFeatures(const Shape<2>& shape)
    : corners(corners_of_polygon(shape)), patches{shape} {}

template <>
OutlineFeatures<3>::OutlineFeatures(const Shape<3>& shape) {
  Surface surface(shape.facets());
  const Tracing tracing(surface);
  for (const Surface::Point p : tracing.corners()) corners.push_back(surface.x()[p]);
  creases = tracing.creases();
  patches = surface.patches(shape.facets());
}

}  // namespace cosurge::fem
