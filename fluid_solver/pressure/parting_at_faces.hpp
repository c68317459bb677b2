// The divergence of the velocity beside walls and bodies.
#pragma once

#include "fluid_solver/cell_grid.hpp"
#include "fluid_solver/particles.hpp"

namespace cosurge::fluid {

/// Sum of w_ij u_ij . x_ij over the particles within `re` [m] of particle i [m2/s]: times d / (lambda0 n0)
/// the divergence (10b). Water slides along faces: a pair of water and a point of a wall or body with the
/// normal n has (u_ij . n) n in place of u_ij. In the row of such a point itself the water's velocity along
/// the face counts relative to its mean over the neighbours, and water behind a body's face does not count.
/// Two points of bodies do not count for each other. `velocity` [m/s] is that of each particle;
/// `kick` is added to the velocity of walls and bodies.
///
/// The row of a point of a wall or body has water on one side only; its sum is multiplied by `face_factor`;
/// then the momentum that a plane wall gives to the water by a sudden motion is exact (10c).
template <int dim>
double parting_at_faces(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                        const CellGrid<dim>& grid, int i, double re, double face_factor,
                        const Vec<dim>& kick);

}  // namespace cosurge::fluid
