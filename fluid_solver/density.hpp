// Particle number density and the free surface.
#pragma once

#include "fluid_solver/neighbors.hpp"
#include "fluid_solver/reference_values.hpp"

namespace cosurge::fluid {

/// When a particle counts as free surface (Tsukamoto, Cheng & Motezuki 2016, doi 10.1002/fld.4213): eq. (5).
struct FreeSurfaceCriterion {
  double beta;   ///< threshold as a share of n0 [-]
  double delta;  ///< centroid deviation [m]
};

/// Computes the number density n_i = sum of w(r_ij), eq. (2), for particles with pressure, and their surface
/// flag by eqs. (4) and (5): n_i < beta n0 and |sum w x_ij| / sum w > delta. Particles with at most `few`
/// neighbours are always free surface. All kinds count as neighbours.
template <int dim>
void density_and_free_surface(Particles<dim>& particles, const Neighbors<dim>& neighbors, double n0,
                              const FreeSurfaceCriterion& criterion);

/// Computes the same number density for a pressure equation with an OpenSurface. Only particles that cannot
/// have a pressure are flagged as free surface: drops with at most `few` neighbours, and points of walls and
/// bodies without water within r_e.
/// @return the smooth density, eq. (2b) with this radius, of each particle with a pressure, by place [-]
template <int dim>
std::vector<double> density_and_lone_particles(Particles<dim>& particles, const Neighbors<dim>& neighbors);

}  // namespace cosurge::fluid
