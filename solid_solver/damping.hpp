// Damping of all models by one physical parameter.
#pragma once

#include <vector>

#include "solid_solver/structure.hpp"

namespace cosurge {

/// Rate c [1/s] of each body's damping force -c rho v, so that its first mode has `solid.damping_ratio` of
/// critical damping: c = 2 ratio omega_1, omega_1 from finite elements (docs/method_solid.md, section 10).
/// Zeros without damping.
/// @throws Error for a body that is free to move as a whole: it has no first mode.
template <int dim>
std::vector<double> damping_rates(const Structure<dim>& structure);

}  // namespace cosurge
