// The rigid motion nearest to the motion of given points.
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "common/geometry/lattice.hpp"

namespace cosurge::fluid {

/// Velocity v + W (x - c) of a rigid body.
template <int dim>
struct RigidMotion {
  Vec<dim> centre = Vec<dim>::Zero();    ///< c [m]
  Vec<dim> velocity = Vec<dim>::Zero();  ///< v [m/s]
  Mat<dim> spin = Mat<dim>::Zero();      ///< W, skew-symmetric [1/s]

  Vec<dim> at(const Vec<dim>& x) const { return velocity + spin * (x - centre); }
};

/// Least squares over points with positions x [m] and velocities u [m/s], at least one.
template <int dim>
RigidMotion<dim> rigid_motion(const std::vector<Vec<dim>>& x, const std::vector<Vec<dim>>& u) {
  constexpr int spins = dim * (dim - 1) / 2;
  const auto count = static_cast<double>(x.size());
  RigidMotion<dim> motion;
  for (std::size_t k = 0; k < x.size(); ++k) {
    motion.centre += x[k] / count;
    motion.velocity += u[k] / count;
  }
  Eigen::Matrix<double, spins, spins> matrix = Eigen::Matrix<double, spins, spins>::Zero();
  Eigen::Matrix<double, spins, 1> side = Eigen::Matrix<double, spins, 1>::Zero();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Vec<dim> arm = x[k] - motion.centre;
    Eigen::Matrix<double, dim, spins> turning = Eigen::Matrix<double, dim, spins>::Zero();  // by unit spins
    int spin = 0;
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b, ++spin) {
        turning(b, spin) = arm[a];
        turning(a, spin) = -arm[b];
      }
    matrix += turning.transpose() * turning;
    side += turning.transpose() * (u[k] - motion.velocity);
  }
  const Eigen::Matrix<double, spins, 1> rates = matrix.ldlt().solve(side);
  int spin = 0;
  for (int a = 0; a < dim; ++a)
    for (int b = a + 1; b < dim; ++b, ++spin) {
      motion.spin(b, a) = rates[spin];
      motion.spin(a, b) = -rates[spin];
    }
  return motion;
}

}  // namespace cosurge::fluid
