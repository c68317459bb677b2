// The divergence of the velocity beside walls and bodies.
#pragma once

#include "fluid_solver/cell_grid.hpp"
#include "fluid_solver/particles.hpp"

namespace cosurge::fluid {

/// Sum of w_ij u_ij . x_ij over the particles within `re` [m] of particle i [m2/s], which is the divergence
/// (10b) times lambda0 n0 / d. Water slides along faces: a pair of a water particle and a point of a wall or
/// body with the normal n uses (u_ij . n) n in place of u_ij. In the sum for a point of a wall or body, the
/// velocity of the water along the face is relative to its mean over the neighbours, and water behind a
/// body's face does not count. Pairs of points of bodies do not count. `velocity` [m/s] is that of each
/// particle; `kick` [m/s] is added to the velocity of walls and bodies.
///
/// A point of a wall or body has water on one side only. Its sum is multiplied by `face_factor`, so that the
/// momentum that a plane wall gives to the water by a sudden motion is exact (10c).
template <int dim>
double parting_at_faces(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                        const CellGrid<dim>& grid, int i, double re, double face_factor,
                        const Vec<dim>& kick);

}  // namespace cosurge::fluid
