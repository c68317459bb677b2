// Collisions that keep particles from overlapping, and water from going through faces.
#pragma once

#include "fluid_solver/neighbors.hpp"

namespace cosurge::fluid {

struct CollisionLaw {
  double distance;     ///< below which particles collide [m]
  double restitution;  ///< [-]
  double spacing;      ///< l0 [m]
};

/// Whether the face of a wall's or body's particle is where a water particle is: the face lies half a spacing
/// before its particle, and as far to each side as the lattice leaves no gap. `way` [m] leads from the
/// water particle to the particle of the face, whose unit normal is n.
template <int dim>
bool at_face(const Vec<dim>& way, const Vec<dim>& n, double spacing) {
  constexpr double ahead = 0.5, aside = 0.75;  // spacings
  const double height = -way.dot(n);
  const double beside = way.squaredNorm() - height * height;
  return std::abs(height) < ahead * spacing && beside < aside * aside * spacing * spacing;
}

/// Velocity change of fluid particle i by eq. (7): each neighbour closer than `distance` that approaches it
/// takes the share m_j / (m_i + m_j) of (1 + restitution) times the approach speed, along the line between
/// them; walls and bodies are taken as infinitely heavy. Momentum between fluid particles is conserved.
/// Where a wall or body has a normal, water meets its face and not its particles, eq. (7a): what reaches the
/// face loses its speed across it, and slides along it freely. Calls `at(j, change)` with the part of the
/// change [m/s] that the face of each particle j of a wall or body causes.
template <int dim, typename AtFace>
Vec<dim> collision(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                   const CollisionLaw& law, AtFace&& at) {
  Vec<dim> change = Vec<dim>::Zero();
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double) {
    const Vec<dim>& n = particles.normal[j];
    if (!n.isZero()) {  // a face has many particles: the velocity change by the others already counts
      const double approach = (particles.u[j] - particles.u[i] - change).dot(n);
      if (approach <= 0 || !at_face(x_ij, n, law.spacing)) return;
      const Vec<dim> by_face = (1 + law.restitution) * approach * n;
      change += by_face;
      at(j, by_face);
      return;
    }
    if (r >= law.distance || r == 0) return;
    const double approach = (particles.u[i] - particles.u[j]).dot(x_ij) / r;
    if (approach <= 0) return;
    const double share = particles.kind[j] == Kind::fluid ? 0.5 : 1.0;
    change -= share * (1 + law.restitution) * approach / r * x_ij;
  });
  return change;
}

}  // namespace cosurge::fluid
