// Walls that bodies keep from all water.
#pragma once

#include <vector>

#include "common/body_sites.hpp"
#include "fluid_solver/particles.hpp"

namespace cosurge::fluid {

/// Makes wall particles dummies where water cannot come within `reach` [m], since `bodies` fill the tank
/// there: under a body that stands on the floor or spans the tank, a moving one would squeeze them.
template <int dim>
void bury_walls(Particles<dim>& particles, const Box<dim>& tank, const std::vector<BodySites<dim>>& bodies,
                double reach, double spacing);

}  // namespace cosurge::fluid
