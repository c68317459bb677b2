// Isotropic elastic material, and stress from the deformation gradient.
#pragma once

#include <Eigen/LU>
#include <cmath>

#include "common/vec.hpp"

namespace cosurge {

/// Density, Young's modulus, Poisson's ratio, material law of large strains, and the condition normal to the
/// plane of a scene of two dimensions.
struct Elasticity {
  double density;             ///< [kg/m3]
  double young_modulus;       ///< [Pa]
  double poisson_ratio;       ///< [-]
  bool plane_stress = false;  ///< no stress normal to the plane; otherwise no strain
  bool neo_hookean = false;   ///< compressible neo-Hookean law; otherwise St. Venant-Kirchhoff

  double mu() const { return young_modulus / (2 * (1 + poisson_ratio)); }

  /// Lamé's constant of the material in space.
  double lambda_in_space() const {
    return young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
  }

  /// Lamé's constant of the scene: in plane stress 2 lambda mu / (lambda + 2 mu) = E nu / (1 - nu^2), with
  /// which St. Venant-Kirchhoff's law in the plane is that in space without stress across, for any strain.
  double lambda() const {
    return plane_stress ? young_modulus * poisson_ratio / (1 - poisson_ratio * poisson_ratio)
                        : lambda_in_space();
  }

  double shear_speed() const { return std::sqrt(mu() / density); }                      ///< c_s [m/s]
  double pressure_speed() const { return std::sqrt((lambda() + 2 * mu()) / density); }  ///< c_p [m/s]
};

}  // namespace cosurge
