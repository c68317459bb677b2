// The cantilever of beam theory.
#pragma once

namespace cosurge {

/// A plate clamped at its foot, per metre of width, in plane strain or (Poisson's ratio 0) in plane stress.
struct Cantilever {
  double length;         ///< [m]
  double thickness;      ///< [m]
  double density;        ///< [kg/m3]
  double young_modulus;  ///< [Pa]
  double poisson_ratio;  ///< [-]

  double rigidity() const;  ///< E h^3 / (12 (1 - nu^2)) [N m]

  /// First frequency [Hz] of Timoshenko's beam, with shear (factor 5/6) and rotatory inertia.
  double timoshenko() const;

  /// The same of Euler and Bernoulli's, without them.
  double euler_bernoulli() const;

  /// Deflection of the end under a uniform pressure, linear, with shear [m/Pa].
  double deflection() const;
};

}  // namespace cosurge
