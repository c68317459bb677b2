// Corners of an outline.
#pragma once

#include "common/shape.hpp"

namespace cosurge::fem {

/// Points of an outline around which its normals span the space: in the plane, where sides meet at more than
/// some 20 degrees. In lexicographical order.
template <int dim>
std::vector<Vec<dim>> corners_of(const Shape<dim>& shape);

}  // namespace cosurge::fem
