// The axes along which a shape is gridded.
#pragma once

#include "common/geometry/shape.hpp"

namespace cosurge::fem {

/// A rotation whose columns are the axes, in the order of the coordinates they are closest to. If the normals
/// of more than half of an outline's surface are parallel to three orthogonal axes, these are used; otherwise
/// the principal axes of its moments, or the coordinate axes where principal moments are equal. A box has the
/// coordinate axes.
template <int dim>
Mat<dim> axes_of(const Shape<dim>& shape);

}  // namespace cosurge::fem
