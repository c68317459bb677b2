// Damping of relative motion of particles at the free surface.
#pragma once

#include <algorithm>

#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {

/// Parameters of the damping at the surface, eq. (7b).
struct SurfaceDamping {
  double thin;   ///< number density below which a particle is near the surface [-]
  double share;  ///< epsilon: share of a relative velocity that a full neighbourhood removes in a step [-]
};

/// Parameters of eq. (7b) for a step `dt` [s] at the propagation speed c [m/s]: the relative velocity of
/// particles at the surface decays at the rate c / (2 l0).
inline SurfaceDamping surface_damping(double n0, double c, double spacing, double dt) {
  constexpr double thin = 0.8;    // limit as a share of n0; the outer layer of the lattice has 0.68
  constexpr double rate = 0.5;    // rate as a multiple of c / l0
  constexpr double stable = 0.3;  // limit of epsilon, for the stability of explicit diffusion
  return {.thin = thin * n0, .share = std::min(stable, rate * dt * c / spacing)};
}

/// Velocity change of water particle i, eq. (7b): epsilon / n0 sum of w ((u_j - u_i) . x_ij) x_ij / r^2 over
/// pairs of water particles of which one is near the surface. Pairs exchange equal and opposite impulses
/// along the line between them: momentum and angular momentum are conserved, rigid rotation is not damped,
/// and kinetic energy only decreases. It suppresses the motion that errors of the pressure gradient cause
/// where neighbourhoods are incomplete.
template <int dim>
Vec<dim> damp_surface(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i, double n0,
                      const SurfaceDamping& damping) {
  const auto thin = [&](int k) { return particles.n[k] < damping.thin; };
  const bool i_thin = thin(i);
  Vec<dim> sum = Vec<dim>::Zero();
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double w) {
    if (particles.kind[j] != Kind::fluid || r == 0 || !(i_thin || thin(j))) return;
    sum += w * (particles.u[j] - particles.u[i]).dot(x_ij) / (r * r) * x_ij;
  });
  return damping.share / n0 * sum;
}

}  // namespace cosurge::fluid
