// Wall particles of an obstacle in layers parallel to its outline.
#pragma once

#include <optional>

#include "common/geometry/shape.hpp"
#include "fluid_solver/particles.hpp"

namespace cosurge::fluid {

/// A particle of a wall at the start.
template <int dim>
struct WallSite {
  Vec<dim> x;
  Kind kind;
};

/// Fills an outline. The first layer, of kind `wall`, lies half a spacing below the outline; `dummy_layers`
/// more layers of dummies lie one spacing apart behind it. Along a layer particles are a spacing apart. Sites
/// of the lattice stay where they are deeper than the layers, and where all of the outline near them lies on
/// faces of lattice cells. Where the body is too thin for a layer, sites of the lattice fill it. An outline
/// whose parts overlap is filled with sites of the lattice alone. With `tank`, facets of the outline in the
/// tank's floor and side walls have no layers. The result does not depend on the number of threads.
template <int dim>
std::vector<WallSite<dim>> fitted_layout(const Shape<dim>& shape, const std::optional<Box<dim>>& tank,
                                         int dummy_layers, double spacing);

}  // namespace cosurge::fluid
