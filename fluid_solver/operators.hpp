// Differential operators on particles.
#pragma once

#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/reference_values.hpp"

namespace cosurge::fluid {

/// Pressure gradient of particle i, eq. (9): (d / n0) sum of (P_j - P_min) x_ij / r^2 w over neighbours with
/// a pressure, P_min the smallest pressure of i and those neighbours (Koshizuka & Oka 1996). Pushes particles
/// apart only.
template <int dim>
Vec<dim> gradient_p_min(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i, double n0);

/// Pressure gradient of particle i, eq. (9b): (d / n0) sum of (P_j + P_i) x_ij / r^2 w. It is equal and
/// opposite within every pair, so that momentum is conserved, and it pushes particles towards even spacing.
/// Dummies and inner points of bodies represent P_j = max(lowest, P_i + rho g . x_ij); `rho_g` [N/m3],
/// `lowest` [Pa].
template <int dim>
Vec<dim> gradient_conserving(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                             double n0, const Vec<dim>& rho_g, double lowest);

/// The two terms of eq. (9c).
template <int dim>
struct CorrectedGradient {
  /// M^-1 (d / n0) sum of (P_j - P_i) x_ij / r^2 w over neighbours with a pressure, M = (d / n0) sum of x_ij
  /// (x) x_ij / r^2 w. Exact for a linear pressure on any arrangement; without M^-1 where the neighbours lie
  /// nearly on a line.
  Vec<dim> gradient;

  /// (d / n0) (P_i - P_min) sum of x_ij / r^2 w over all neighbours, P_min the smallest pressure of i and its
  /// neighbours. Zero where particles are evenly spaced; elsewhere it separates crowded particles, which the
  /// corrected gradient alone does not.
  Vec<dim> repulsion;
};

/// Pressure gradient of particle i, eq. (9c).
template <int dim>
CorrectedGradient<dim> gradient_corrected(const Particles<dim>& particles, const Neighbors<dim>& neighbors,
                                          int i, double n0);

/// Direction in which particle i would be less crowded, eq. (18): -(d / n0) sum of x_ij / r w over all
/// neighbours; zero at and next to the free surface, where the sum points out of the water.
template <int dim>
Vec<dim> even_out(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i, double n0);

/// Largest approach speed [m/s] of particle i and a neighbour, at least 0. Pairs without water do not count;
/// for a point of a wall or body only the component normal to its face counts, at an edge to the face that
/// the water sees (SeenFaces). `kick` [m/s] is added to the velocity of walls and bodies. `spacing`: l0 [m].
template <int dim>
double approach_speed(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                      const Vec<dim>& kick, double spacing);

/// Velocity divergence at particle i, eq. (10): (d / n0) sum of (u_j - u_i) . x_ij / r^2 w over all
/// neighbours. Pairs of points of bodies are left out: a pressure in response to the compression of a
/// structure would compress it further. `velocity` [m/s] is that of each particle; `kick` [m/s] is added to
/// the velocity of walls and bodies. The source `mixed` uses it near its free surface and bodies;
/// `time_scale` uses (10b) everywhere.
template <int dim>
double near_divergence(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                       const Neighbors<dim>& neighbors, int i, double n0, const Vec<dim>& kick);

}  // namespace cosurge::fluid
