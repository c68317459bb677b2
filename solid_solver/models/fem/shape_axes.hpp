// The axes along which a shape is gridded.
#pragma once

#include "common/geometry/shape.hpp"

namespace cosurge::fem {

/// A rotation; its columns are the axes, in the order of the coordinates they are closest to. Where the
/// normals of more than half of an outline's surface lie along axes at right angles, these; otherwise the
/// principal axes of its moments, or the coordinates' where principal moments are alike. A box has the
/// coordinates'.
template <int dim>
Mat<dim> axes_of(const Shape<dim>& shape);

}  // namespace cosurge::fem
