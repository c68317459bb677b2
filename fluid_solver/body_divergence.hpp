// The divergence that a motion of the bodies alone makes in the water.
#pragma once

#include "common/participant.hpp"
#include "fluid_solver/covered_walls.hpp"
#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/pressure/poisson_equation.hpp"

namespace cosurge::fluid {

/// The bodies among the particles of a step.
template <int dim>
struct BodiesInWater {
  const Particles<dim>& particles;
  const Neighbors<dim>& neighbors;
  const ReferenceValues& reference;     ///< values for the radius of the neighbour lists
  const PoissonEquation<dim>& poisson;  ///< assembled
  const std::vector<int>& seen;         ///< the point whose velocity the water sees in each body point
  const std::vector<Cover>& covers;     ///< walls that bodies cover
  const std::vector<std::int32_t>& body_place;  ///< place of each body point among the particles
};

/// Divergence [1/s] at each unknown of the pressure equation, eq. (10b), (10c), where the bodies' points have
/// the velocities `motion` (dimension x points [m/s]) and all else is at rest.
template <int dim>
std::vector<double> body_divergence(const BodiesInWater<dim>& bodies, const Field& motion);

}  // namespace cosurge::fluid
