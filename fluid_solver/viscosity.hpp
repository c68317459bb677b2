// Viscosity of the water, and its friction on walls and bodies.
#pragma once

#include <limits>

#include "fluid_solver/neighbors.hpp"

namespace cosurge::fluid {

/// The face that a particle of water lies before.
template <int dim>
struct FaceBefore {
  std::int32_t place = -1;  ///< of the nearest point of a first layer; -1: none within the radius
  /// From the face to the water, at least half a spacing [m].
  double distance = std::numeric_limits<double>::infinity();
  /// Velocity gradient of the rigid rotation nearest to the motion of the points around that one [1/s].
  Mat<dim> spin = Mat<dim>::Zero();
};

/// `spacing`: l0 [m]; the face lies half of it before its first layer.
template <int dim>
FaceBefore<dim> face_before(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                            double spacing);

/// Velocities of a wall or body, minus that of the water before it, times the factor by which the velocity
/// is extrapolated from the water to a point j behind the face: a velocity that changes linearly with the
/// distance is that of the wall on the face (Morris, Fox & Zhu 1997). Behind no face nothing is extrapolated.
template <int dim>
struct BeyondFace {
  Vec<dim> of_face;  ///< with the velocity of the face [m/s]: what the water feels
  Vec<dim>
      of_motion;  ///< with the velocity that the rotation of the wall has at the place of the water [m/s]
};

/// `kick` [m/s] is added to the velocity of walls and bodies, since that of the predicted water contains it.
template <int dim>
BeyondFace<dim> beyond_face(const Particles<dim>& particles, int i, int j, const FaceBefore<dim>& face,
                            const Vec<dim>& kick);

/// Laplacian of the velocity at water particle i, eq. (8): (2 d / (lambda0 n0)) sum of (u_j - u_i) w over all
/// neighbours [1/(m s)], extrapolated behind faces.
template <int dim>
Vec<dim> velocity_laplacian(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                            const FaceBefore<dim>& face, const Vec<dim>& kick, double n0, double lambda0);

}  // namespace cosurge::fluid
