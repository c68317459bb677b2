// Isotropic elastic material, and stress from the deformation gradient.
#pragma once

#include <Eigen/LU>
#include <cmath>

#include "common/vec.hpp"

namespace cosurge {

/// Young's modulus and Poisson's ratio; a scene of two dimensions is in plane strain.
struct Elasticity {
  double density;        ///< [kg/m3]
  double young_modulus;  ///< [Pa]
  double poisson_ratio;  ///< [-]

  double mu() const { return young_modulus / (2 * (1 + poisson_ratio)); }
  double lambda() const {
    return young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
  }
  double shear_speed() const { return std::sqrt(mu() / density); }                      ///< c_s [m/s]
  double pressure_speed() const { return std::sqrt((lambda() + 2 * mu()) / density); }  ///< c_p [m/s]
};

/// Von Mises stress [Pa] of the Cauchy stress J^-1 F S F^T with S = lambda tr(E) I + 2 mu E, E = (F^T F - I)
/// / 2 (St. Venant-Kirchhoff; docs/method_solid.md, S19). F has ones in the directions that the scene lacks.
template <int dim>
double von_mises_stress(const Mat<dim>& deformation_gradient, const Elasticity& material) {
  Mat<3> F = Mat<3>::Identity();
  F.template topLeftCorner<dim, dim>() = deformation_gradient;
  const Mat<3> E = 0.5 * (F.transpose() * F - Mat<3>::Identity());
  const Mat<3> S = material.lambda() * E.trace() * Mat<3>::Identity() + 2 * material.mu() * E;
  const Mat<3> stress = F * S * F.transpose() / F.determinant();
  const Mat<3> deviator = stress - stress.trace() / 3 * Mat<3>::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

}  // namespace cosurge
