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

/// Finds the wall particles that a body touches, and the wall particles of the tank that a moving obstacle
/// touches. Particles touch within 1.1 spacings; the nearest one covers the wall particle. A wall particle
/// that is covered by an inner point of a body, or by an obstacle, becomes a dummy. Walls::move makes it a
/// wall particle again.
template <int dim>
std::vector<Cover> cover_walls(Particles<dim>& particles, const Neighbors<dim>& neighbors,
                               const Walls<dim>& walls, double spacing);

/// Gives covered wall particles the velocity and the normal of the particles that cover them: the water meets
/// the body or obstacle there, and cannot slide along the wall.
template <int dim>
void follow_covers(Particles<dim>& particles, const std::vector<Cover>& covers);

}  // namespace cosurge::fluid
