// The grid of elements of a body, whose side is chosen where the case does not give it.
#pragma once

#include "solid_solver/models/fem/fitted_grid.hpp"

namespace cosurge::fem {

/// @param longest side of an element [m]; 0: it is chosen. A box then gets a third of its thickness, an
/// outline a third of 2 volume / surface. In three dimensions an outline gets longer sides, with about 250
/// elements, where the elements can be fitted to the outline with them.
/// @param body its number, for messages
/// @throws Error as FittedGrid does
template <int dim>
FittedGrid<dim> chosen_grid(const Shape<dim>& shape, double longest, int body);

}  // namespace cosurge::fem
