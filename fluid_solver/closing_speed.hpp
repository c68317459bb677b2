// How fast the bodies are driven into the water.
#pragma once

#include <vector>

#include "fluid_solver/bodies.hpp"
#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/walls.hpp"

namespace cosurge::fluid {

/// The bodies of a step and where they are.
template <int dim>
struct DrivenBodies {
  const Bodies<dim>& bodies;
  const std::vector<Vec<dim>>& normal;     ///< of the face of each point, towards the water
  const std::vector<std::int32_t>& place;  ///< of each point among the particles
};

/// Largest speed [m/s] at which a body that is not held at rest closes on water beside its face: along the
/// normal of the face, of the motion as a rigid body, and at most the speed of that motion. So bodies that
/// drift with the water, bodies that oscillate about clamps, and water that hits a body do not count.
/// The motion is that against the tank. `end` and `dt`: of the window [s].
template <int dim>
double closing_speed(const DrivenBodies<dim>& driven, const Particles<dim>& particles,
                     const Neighbors<dim>& neighbors, const Walls<dim>& walls, double end, double dt);

}  // namespace cosurge::fluid
