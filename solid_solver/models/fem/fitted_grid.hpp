// A grid of elements in a shape.
#pragma once

#include <vector>

#include "common/geometry/shape.hpp"
#include "common/participant.hpp"
#include "solid_solver/models/fem/quadratic_element.hpp"

namespace cosurge::fem {

/// Elements of second order. A box is divided evenly. Another shape gets the cells of a CellGrid; their outer
/// nodes go to the outline and share it evenly, one of them to each of its corners and in space some along
/// each of its sharp edges, and the others follow (docs/method_solid.md, section 5).
template <int dim>
struct FittedGrid {
  using Element = QuadraticElement<dim>;

  Vec<dim> side;                                               ///< sides of a cell [m]
  Field position;                                              ///< positions of the nodes [m]
  std::vector<std::array<Eigen::Index, Element::nodes>> node;  ///< nodes of each element, ascending

  /// @param longest side of an element [m]; 0 for a third of a box's thickness, or of 2 volume / surface
  /// @param body its number, for messages
  /// @throws Error where elements are too many, fall apart, would be turned inside out, or miss 2 % of the
  /// volume.
  FittedGrid(const Shape<dim>& shape, double longest, int body);
};

}  // namespace cosurge::fem
