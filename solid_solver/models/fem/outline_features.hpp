// Sharp edges of an outline, and the faces between them.
#pragma once

#include <array>
#include <vector>

#include "common/geometry/shape.hpp"

namespace cosurge::fem {

/// A sharp edge in space: a chain of edges between triangles that meet at more than some 30 degrees.
struct Crease {
  std::array<std::size_t, 2> ends;  ///< corners, never the same
  std::vector<Vec<3>> points;       ///< from the one to the other

  double length() const;
  Vec<3> at(double share) const;           ///< `share` of its length from its first point
  double distance(const Vec<3>& x) const;  ///< [m]
};

/// Corners of an outline: points around which its normals span the space, in the plane where sides meet at
/// more than some 20 degrees; in space also where creases begin, end, meet or turn by more than some 30
/// degrees, and some between, where one closes on itself. Patches are the parts of the surface between
/// creases, in the plane the whole outline. All in an order of their own.
template <int dim>
struct OutlineFeatures {
  std::vector<Vec<dim>> corners;
  std::vector<Crease> creases;  ///< none in the plane
  std::vector<Shape<dim>> patches;

  explicit OutlineFeatures(const Shape<dim>& shape);
};

}  // namespace cosurge::fem
