// The grid of elements of a body, whose side is chosen where the case does not give it.
#pragma once

#include "solid_solver/models/fem/fitted_grid.hpp"

namespace cosurge::fem {

/// Makes the grid of a body with sides of at most `longest` [m]. If it is 0, a box gets a third of its
/// thickness, and an outline a third of 2 volume / surface. In three dimensions an outline gets longer sides,
/// about 250 elements, if these can be fitted to it.
/// @param body its number, for messages
/// @throws Error as FittedGrid does
template <int dim>
FittedGrid<dim> chosen_grid(const Shape<dim>& shape, double longest, int body);

}  // namespace cosurge::fem
