// A grid of elements that fills a shape.
#pragma once

#include <vector>

#include "common/geometry/shape.hpp"
#include "common/participant.hpp"
#include "solid_solver/models/fem/quadratic_element.hpp"

namespace cosurge::fem {

/// Elements of second order. A box is divided evenly. Another shape gets the cells of a CellGrid, whose outer
/// nodes are moved to the outline and distributed evenly on it: one node at each corner of the outline and,
/// in space, nodes along each of its sharp edges. Inner nodes follow by smoothing (docs/method_solid.md,
/// section 5).
template <int dim>
struct FittedGrid {
  using Element = QuadraticElement<dim>;

  Vec<dim> side;                                               ///< sides of a cell [m]
  Field position;                                              ///< positions of the nodes [m]
  std::vector<std::array<Eigen::Index, Element::nodes>> node;  ///< nodes of each element, ascending

  /// @param longest side of an element [m]; 0 for a third of a box's thickness, or of 2 volume / surface
  /// @param body its number, for messages
  /// @throws Error if there are too many elements, if they are not connected or would be inverted, or if
  /// their volume differs by more than 2 % from that of the shape.
  FittedGrid(const Shape<dim>& shape, double longest, int body);
};

}  // namespace cosurge::fem
