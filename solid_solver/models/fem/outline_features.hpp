// Sharp edges of an outline, and the faces between them.
#pragma once

#include <array>
#include <vector>

#include "common/geometry/shape.hpp"

namespace cosurge::fem {

/// A sharp edge in space: a chain of edges between triangles that meet at more than some 30 degrees.
struct Crease {
  std::array<std::size_t, 2> ends;  ///< indices of the corners at its ends, never the same
  std::vector<Vec<3>> points;       ///< points from the first end to the second

  double length() const;
  Vec<3> at(double share) const;           ///< point at `share` of its length
  double distance(const Vec<3>& x) const;  ///< [m]
};

/// Features of an outline. Corners are points around which the normals span the space; in the plane, where
/// sides meet at more than about 20 degrees; in space also where creases begin, end, meet or turn by more
/// than about 30 degrees. A closed crease gets additional corners. Patches are the parts of the surface
/// between creases, in the plane the whole outline.
template <int dim>
struct OutlineFeatures {
  std::vector<Vec<dim>> corners;
  std::vector<Crease> creases;  ///< none in the plane
  std::vector<Shape<dim>> patches;

  explicit OutlineFeatures(const Shape<dim>& shape);
};

}  // namespace cosurge::fem
