// How the generalised-alpha method damps an oscillation.
#pragma once

#include <Eigen/Eigenvalues>

#include "solid_solver/models/fem/generalised_alpha.hpp"

namespace cosurge::fem {

/// Factor on the amplitude of an undamped oscillation in a step of `angle` = omega dt [rad]: the spectral
/// radius of (S25), from 1 for a resolved oscillation to rho_infinity for an infinitely fast one.
inline double amplitude_factor(const AlphaConstants& constants, double angle) {
  const auto& [alpha_m, alpha_f, beta, gamma] = constants;
  // Unknowns (u, dt v, dt^2 a): the new acceleration balances the forces, u and v follow from it.
  const double square = angle * angle, balance = 1 - alpha_m + (1 - alpha_f) * square * beta;
  const Eigen::RowVector3d acceleration =
      -Eigen::RowVector3d(square, (1 - alpha_f) * square, alpha_m + (1 - alpha_f) * square * (0.5 - beta)) /
      balance;
  Eigen::Matrix3d step;
  step << 1, 1, 0.5 - beta, 0, 1, 1 - gamma, 0, 0, 0;
  step += Eigen::Vector3d(beta, gamma, 1) * acceleration;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace cosurge::fem
