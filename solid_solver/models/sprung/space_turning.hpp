// Rotation of a rigid body in space, free about all axes.
#pragma once

#include <Eigen/Geometry>
#include <functional>

#include "common/vec.hpp"

namespace cosurge::sprung {

/// dp/dt = moment of the loads - C omega - dV/dtheta, with the angular momentum p, dampers C, and springs and
/// preloads about the three axes of space with the energy V = sum k_i theta_i^2 / 2 - t_i theta_i of the
/// rotation vector theta.
struct SpaceTurning {
  Mat<3> inertia;                     ///< about the pivot, where the body is drawn [kg m2]
  Vec<3> stiffness = Vec<3>::Zero();  ///< [N m/rad]
  Vec<3> damping = Vec<3>::Zero();    ///< [N m s/rad]
  Vec<3> preload = Vec<3>::Zero();    ///< [N m]
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Vec<3> momentum = Vec<3>::Zero();  ///< angular, in space [kg m2/s]

  /// The moment of dead loads, from the mean of the body's rotation matrices before and after a step [N m].
  using Moment = std::function<Vec<3>(const Mat<3>& mean)>;

  /// One step of dt [s] by the mid-point rule of Simo & Wong (1991, Int. J. Numer. Methods Eng. 31, 19), with
  /// the springs' moment as a discrete gradient (Gonzalez 1996, J. Nonlinear Sci. 6, 449): angular momentum
  /// is conserved without loads, and the work of loads and springs equals the change of the energies exactly
  /// (docs/method_solid.md, S47). Second order.
  /// @throws NumericalError where the loads turn the body too fast for the step, or by more than half a turn
  /// against springs.
  void step(const Moment& moment, double dt);

  Mat<3> rotation() const { return attitude.toRotationMatrix(); }
  Mat<3> inertia_in_space() const { return rotation() * inertia * rotation().transpose(); }
  Vec<3> speed() const { return inertia_in_space().llt().solve(momentum); }  ///< angular, in space [rad/s]
  double kinetic_energy() const { return 0.5 * momentum.dot(speed()); }
  bool has_springs() const { return !stiffness.isZero(0) || !preload.isZero(0); }
  double spring_energy() const { return spring_energy(attitude); }

 private:
  double spring_energy(const Eigen::Quaterniond& at) const;
  void check_springs(const Eigen::Quaterniond& after) const;
  Vec<3> spring_moment(const Eigen::Quaterniond& after, const Vec<3>& turned) const;
};

/// The matrix of a x.
inline Mat<3> cross_matrix(const Vec<3>& a) {
  return (Mat<3>() << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0).finished();
}

}  // namespace cosurge::sprung
