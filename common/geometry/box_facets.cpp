#include "common/geometry/box_facets.hpp"

namespace cosurge {

std::vector<Facet<2>> facets_of(const Box<2>& box) {
  const Vec<2>&a = box.min, &b = box.max;
  const std::array<Vec<2>, 4> corner = {a, Vec<2>(b[0], a[1]), b, Vec<2>(a[0], b[1])};
  return {{corner[0], corner[1]}, {corner[1], corner[2]}, {corner[2], corner[3]}, {corner[3], corner[0]}};
}

std::vector<Facet<3>> facets_of(const Box<3>& box) {
  std::vector<Facet<3>> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      std::array<Vec<3>, 4> corner;
      corner.fill(upper ? box.max : box.min);
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const std::array<std::array<bool, 2>, 4> at = {
          {{false, false}, {true, false}, {true, true}, {false, true}}};
      for (std::size_t k = 0; k < 4; ++k) {
        corner[k][u] = at[k][0] ? box.max[u] : box.min[u];
        corner[k][v] = at[k][1] ? box.max[v] : box.min[v];
      }
      if (!upper) std::swap(corner[1], corner[3]);
      triangles.push_back({corner[0], corner[1], corner[2]});
      triangles.push_back({corner[0], corner[2], corner[3]});
    }
  }
  return triangles;
}

}  // namespace cosurge
