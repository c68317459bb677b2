// How fast the structure oscillates: what the water's pressure has to follow.
#pragma once

#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// Angular frequency [rad/s] in vacuum of the slowest oscillation of each body, the highest of all bodies. A
/// body on springs counts with its fastest one. 0 where nothing oscillates: rigid bodies. Deformable bodies:
/// the first mode of finite elements (docs/method.md, eq. (6d)).
/// @param model of the structure
template <int dim>
double slowest_oscillation(const Structure<dim>& structure, const SolidModel& model);

}  // namespace cosurge
