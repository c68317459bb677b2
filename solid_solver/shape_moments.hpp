// Volume, surface and moments of a shape.
#pragma once

#include "common/geometry/shape.hpp"

namespace cosurge {

/// Exact, in two dimensions per metre of width. Corners of an outline go around it, those of triangles all
/// the same way around.
template <int dim>
struct ShapeMoments {
  double volume;    ///< [m^dim]
  double surface;   ///< [m^(dim - 1)]
  Vec<dim> centre;  ///< centre of mass [m]
  Mat<dim> second;  ///< integral of (X - centre) (x) (X - centre) [m^(dim + 2)]

  explicit ShapeMoments(const Shape<dim>& shape);

 private:
  void sum_box(const Vec<dim>& sides);
  void sum_outline(const std::vector<typename Shape<dim>::Facet>& facets);
};

}  // namespace cosurge
