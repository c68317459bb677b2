// The frequency of the structure, which the source of the pressure equation needs.
#pragma once

#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// Largest angular frequency [rad/s] in vacuum among the slowest oscillations of all bodies (docs/method.md,
/// eq. 6d): the first mode of finite elements for a deformable body, the fastest motion of a body on springs.
/// 0 if nothing oscillates.
/// @param model of the structure
template <int dim>
double slowest_oscillation(const Structure<dim>& structure, const SolidModel& model);

}  // namespace cosurge
