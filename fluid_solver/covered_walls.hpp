// Walls that bodies and moving obstacles keep from the water.
#pragma once

#include <vector>

#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/walls.hpp"

namespace cosurge::fluid {

/// A particle of a wall that touches a particle of a body or of an obstacle, by place.
struct Cover {
  std::int32_t wall, by;
};

/// Finds the wall particles that a body touches, and those of the tank that a moving obstacle touches: within
/// 1.1 spacings. The nearest particle covers each. No water comes to such a wall, and a wall particle that an
/// inner point of a body or an obstacle covers becomes a dummy. Walls::move undoes it.
template <int dim>
std::vector<Cover> cover_walls(Particles<dim>& particles, const Neighbors<dim>& neighbors,
                               const Walls<dim>& walls, double spacing);

/// Gives covered wall particles the velocity and normal of their covers: water cannot slide along them,
/// it meets the body or obstacle there.
template <int dim>
void follow_covers(Particles<dim>& particles, const std::vector<Cover>& covers);

}  // namespace cosurge::fluid
