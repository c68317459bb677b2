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
  const std::vector<Vec<dim>>& normal;     ///< normal of the face of each point, towards the water
  const std::vector<std::int32_t>& place;  ///< index of each point among the particles
};

/// Largest speed [m/s] at which a body that is not held at rest approaches the water before its faces: v . n
/// relative to the water, where v is the velocity of the rigid motion nearest to the body's motion and n the
/// normal of the face; at most |v| relative to the tank (docs/method.md, after eq. 6d). So bodies that drift
/// with the water, bodies that oscillate about clamps, and water that hits a resting body do not count. `end`
/// [s] is the end of the window, `dt` [s] its size.
template <int dim>
double closing_speed(const DrivenBodies<dim>& driven, const Particles<dim>& particles,
                     const Neighbors<dim>& neighbors, const Walls<dim>& walls, double end, double dt);

}  // namespace cosurge::fluid
