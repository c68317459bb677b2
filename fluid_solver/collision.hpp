// Collisions that keep particles from overlapping.
#pragma once

#include "fluid_solver/neighbors.hpp"

namespace cosurge::fluid {

struct CollisionLaw {
  double distance;     ///< below which particles collide [m]
  double restitution;  ///< [-]
};

/// Velocity change of fluid particle i by eq. (7): each neighbour closer than `distance` that approaches it
/// takes the share m_j / (m_i + m_j) of (1 + restitution) times the approach speed, along the line between
/// them; walls and bodies are taken as infinitely heavy. Momentum between fluid particles is conserved.
template <int dim>
Vec<dim> collision(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                   const CollisionLaw& law) {
  Vec<dim> change = Vec<dim>::Zero();
  neighbors.each(particles, i, [&](int j, const Vec<dim>& x_ij, double r) {
    if (r >= law.distance || r == 0) return;
    const double approach = (particles.u[i] - particles.u[j]).dot(x_ij) / r;
    if (approach <= 0) return;
    const double share = particles.kind[j] == Kind::fluid ? 0.5 : 1.0;
    change -= share * (1 + law.restitution) * approach / r * x_ij;
  });
  return change;
}

}  // namespace cosurge::fluid
