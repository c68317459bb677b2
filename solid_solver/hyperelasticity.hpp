// Stress, energy and stiffness of large strains.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solid_solver/elasticity.hpp"

namespace cosurge {

/// Response of a material to a deformation. Its stiffness is C = a B (x) B + b (B [x] B + its transpose),
/// that is C : dE = a (B : dE) B + 2 b B dE B.
template <int dim>
struct Response {
  Mat<dim> S;      ///< second Piola-Kirchhoff stress [Pa]
  Mat<dim> B;      ///< I or C^-1
  double a, b;     ///< [Pa]
  double energy;   ///< per reference volume [Pa]
  double across2;  ///< square of the stretch across a scene of two dimensions
};

/// E = (F^T F - I) / 2 from H = F - I, without the cancellation of small strains.
template <int dim>
Mat<dim> green_strain(const Mat<dim>& H) {
  return 0.5 * (H + H.transpose() + H.transpose() * H);
}

/// The measure of volume in the terms with lambda, from H = F - I: tr E in St. Venant-Kirchhoff's law, ln J
/// in the neo-Hookean law; in the plane of a scene of two dimensions.
template <int dim>
double dilatation(const Mat<dim>& H, const Elasticity& m) {
  if (!m.neo_hookean) return H.trace() + 0.5 * H.squaredNorm();
  return std::log(std::max((Mat<dim>::Identity() + H).determinant(), 1e-300));
}

/// S = lambda theta I + 2 mu E (docs/method_solid.md, S20), where theta is tr E or its replacement.
template <int dim>
Response<dim> st_venant_kirchhoff(const Mat<dim>& H, double theta, const Elasticity& m) {
  const Mat<dim> E = green_strain<dim>(H);
  const double lambda = m.lambda(), across = m.lambda_in_space() / (m.lambda_in_space() + 2 * m.mu());
  return {.S = lambda * theta * Mat<dim>::Identity() + 2 * m.mu() * E,
          .B = Mat<dim>::Identity(),
          .a = lambda,
          .b = m.mu(),
          .energy = 0.5 * lambda * theta * theta + m.mu() * E.squaredNorm(),
          .across2 = m.plane_stress ? 1 - 2 * across * theta : 1};
}

/// The compressible neo-Hookean law psi = mu / 2 (tr C - 3 - 2 ln J) + lambda / 2 (ln J)^2 with C = F^T F
/// (Bonet & Wood 2008; docs/method_solid.md, S35): S = mu (I - C^-1) + lambda ln J C^-1. `theta` replaces ln
/// J in the terms with lambda. In plane stress the stretch normal to the plane follows from S_33 = 0, by
/// Newton's method for its logarithm. Undefined where det F <= 0.
template <int dim>
Response<dim> neo_hookean(const Mat<dim>& H, double theta, const Elasticity& m) {
  const double mu = m.mu(), lambda = m.lambda_in_space();
  const Mat<dim> F = Mat<dim>::Identity() + H, inverse = (F.transpose() * F).inverse();
  double across = 0;  // ln of the stretch across
  constexpr int most = 50;
  for (int k = 0; m.plane_stress && k < most; ++k) {
    const double square = std::exp(2 * across);
    const double residual = mu * (square - 1) + lambda * (theta + across);
    const double change = -residual / (2 * mu * square + lambda);
    across += std::clamp(change, -1.0, 1.0);
    if (std::abs(change) < 1e-15) break;
  }
  const double ln_J = dilatation<dim>(H, m) + across, resisted = theta + across;
  const double b = mu - lambda * resisted, square = std::exp(2 * across);
  const double trace = (F.transpose() * F).trace() + square + (dim == 2 ? 0 : -1);
  return {.S = mu * Mat<dim>::Identity() - b * inverse,
          .B = inverse,
          .a = m.plane_stress ? 2 * lambda * b / (lambda + 2 * b) : lambda,
          .b = b,
          .energy = 0.5 * mu * (trace - 3 - 2 * ln_J) + 0.5 * lambda * resisted * resisted,
          .across2 = square};
}

/// @param theta dilatation with the modulus lambda: dilatation(H), or a mean of it over a region
template <int dim>
Response<dim> respond(const Mat<dim>& H, double theta, const Elasticity& material) {
  return material.neo_hookean ? neo_hookean<dim>(H, theta, material)
                              : st_venant_kirchhoff<dim>(H, theta, material);
}

template <int dim>
Response<dim> respond(const Mat<dim>& H, const Elasticity& material) {
  return respond<dim>(H, dilatation<dim>(H, material), material);
}

/// Von Mises stress [Pa] of the Cauchy stress J^-1 F S F^T (docs/method_solid.md, S19); in two dimensions
/// with the stress or strain normal to the plane.
template <int dim>
double von_mises_stress(const Mat<dim>& F, const Elasticity& material) {
  const Response<dim> response = respond<dim>(F - Mat<dim>::Identity(), material);
  const double J = F.determinant() * std::sqrt(std::max(response.across2, 0.0));
  Mat<3> stress = Mat<3>::Zero();
  stress.template topLeftCorner<dim, dim>() = F * response.S * F.transpose() / J;
  if (dim == 2 && !material.plane_stress) {
    const double in_space = material.lambda_in_space();
    const double S_33 = material.neo_hookean ? in_space * std::log(J)
                                             : in_space * green_strain<dim>(F - Mat<dim>::Identity()).trace();
    stress(2, 2) = S_33 / J;
  }
  const Mat<3> deviator = stress - stress.trace() / 3 * Mat<3>::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

}  // namespace cosurge
