// The divergence of the velocity beside walls and bodies.
#pragma once

#include "fluid_solver/cell_grid.hpp"
#include "fluid_solver/particles.hpp"

namespace cosurge::fluid {

/// How the divergence is summed beside walls and bodies.
template <int dim>
struct FaceRule {
  double re;           ///< radius of the sum [m]
  double spacing;      ///< l0 [m]
  double face_factor;  ///< f of eq. (10c)
  Vec<dim> kick;       ///< [m/s], added to the velocity of walls and bodies
};

/// Sum of w_ij u_ij . x_ij over the particles around particle i [m2/s], which is the divergence (10b) times
/// lambda0 n0 / d. Water slides along faces: a pair of a water particle and a point of a wall or body with
/// the normal n uses (u_ij . n) n in place of u_ij; at an edge n is the normal of the face that the water
/// sees (SeenFaces). In the sum for a point of a wall or body, the velocity of the water along the face is
/// relative to its mean over the neighbours, and water behind the face does not count. Pairs of points of
/// bodies do not count. `velocity` [m/s] is that of each particle.
///
/// A point of a wall or body has water on one side only. Its sum is multiplied by the face factor, so that
/// the momentum that a plane wall gives to the water by a sudden motion is exact (10c).
template <int dim>
double parting_at_faces(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                        const CellGrid<dim>& grid, int i, const FaceRule<dim>& rule);

}  // namespace cosurge::fluid
