#include "coupler/report/shape_lines.hpp"

#include <array>
#include <map>
#include <set>

namespace cosurge {
namespace {

/// Corner of a box: bit `axis` of `corner` says which side.
Vec<3> corner_of(const Box<3>& box, int corner) {
  Vec<3> x;
  for (int axis = 0; axis < 3; ++axis) x[axis] = corner >> axis & 1 ? box.max[axis] : box.min[axis];
  return x;
}

using Key = std::array<double, 3>;

Key key_of(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

}  // namespace

std::vector<Polyline<2>> edges_of(const Box<2>& box) {
  const Vec<2> lower_right(box.max[0], box.min[1]), upper_left(box.min[0], box.max[1]);
  return {{box.min, lower_right, box.max, upper_left, box.min}};
}

std::vector<Polyline<3>> edges_of(const Box<3>& box) {
  std::vector<Polyline<3>> lines;
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      if ((corner >> axis & 1) == 0)
        lines.push_back({corner_of(box, corner), corner_of(box, corner | 1 << axis)});
  return lines;
}

std::vector<Polyline<2>> edges_of(const Shape<2>& shape) {
  if (shape.is_box()) return edges_of(shape.bounds());
  Polyline<2> line;
  for (const auto& side : shape.facets()) {
    if (line.empty()) line.push_back(side[0]);
    line.push_back(side[1]);
  }
  return {line};
}

std::vector<Polyline<3>> edges_of(const Shape<3>& shape) {
  if (shape.is_box()) return edges_of(shape.bounds());
  constexpr double straight = 0.94;            // cosine of 20 degrees between normals
  std::map<std::pair<Key, Key>, Vec<3>> open;  // edges that one triangle has shown so far, with its normal
  std::vector<Polyline<3>> lines;
  for (const auto& triangle : shape.facets()) {
    const Vec<3> normal = normal_of(triangle).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec<3>&a = triangle[k], &b = triangle[(k + 1) % 3];
      const auto edge = std::minmax(key_of(a), key_of(b));
      const auto [other, first] = open.try_emplace(edge, normal);
      if (first) continue;
      if (std::abs(other->second.dot(normal)) < straight) lines.push_back({a, b});
      open.erase(other);
    }
  }
  return lines;
}

std::vector<Polyline<2>> tank_edges(const Box<2>& tank) {
  const Vec<2> lower_right(tank.max[0], tank.min[1]), upper_left(tank.min[0], tank.max[1]);
  return {{upper_left, tank.min, lower_right, tank.max}};
}

std::vector<Polyline<3>> tank_edges(const Box<3>& tank) { return edges_of(tank); }

std::vector<Polyline<2>> stairs_of(const std::vector<Vec<2>>& sites, double spacing) {
  std::set<std::pair<long, long>> cells;
  for (const Vec<2>& x : sites)
    cells.emplace(std::lround(x[0] / spacing - 0.5), std::lround(x[1] / spacing - 0.5));
  std::vector<Polyline<2>> lines;
  const auto point = [&](long i, long j) { return Vec<2>(spacing * double(i), spacing * double(j)); };
  for (const auto& [i, j] : cells) {
    if (!cells.contains({i - 1, j})) lines.push_back({point(i, j), point(i, j + 1)});
    if (!cells.contains({i + 1, j})) lines.push_back({point(i + 1, j), point(i + 1, j + 1)});
    if (!cells.contains({i, j - 1})) lines.push_back({point(i, j), point(i + 1, j)});
    if (!cells.contains({i, j + 1})) lines.push_back({point(i, j + 1), point(i + 1, j + 1)});
  }
  return lines;
}

}  // namespace cosurge
