#include "tests/support/timoshenko.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

namespace cosurge {
namespace {

constexpr double shear_factor = 5.0 / 6;

double shear_stiffness(const Cantilever& c) {
  return shear_factor * c.thickness * c.young_modulus / (2 * (1 + c.poisson_ratio));
}

/// Determinant of end moment and shear force by those at the clamp, which is zero if omega is an angular
/// frequency of the beam. With lengths over L: w' = phi + Q / S, phi' = M, Q' = -m w, M' = -Q - j phi, forces
/// over D / L^2 and D / L.
double closure(const Cantilever& c, double omega) {
  const double L = c.length, D = c.rigidity(), mass = c.density * c.thickness;
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A(0, 1) = 1;
  A(0, 3) = D / (L * L * shear_stiffness(c));
  A(1, 2) = 1;
  A(2, 1) = -c.density * std::pow(c.thickness, 3) / 12 * omega * omega * L * L / D;
  A(2, 3) = -1;
  A(3, 0) = -mass * omega * omega * std::pow(L, 4) / D;
  const Eigen::Matrix4d end = A.exp();
  return end.bottomRightCorner<2, 2>().determinant();
}

}  // namespace

double Cantilever::rigidity() const {
  return young_modulus * std::pow(thickness, 3) / (12 * (1 - poisson_ratio * poisson_ratio));
}

double Cantilever::euler_bernoulli() const {
  constexpr double root = 1.8751040687119611;  // cos k cosh k = -1
  return root * root / (2 * std::numbers::pi * length * length) *
         std::sqrt(rigidity() / (density * thickness));
}

double Cantilever::timoshenko() const {
  double low = 0.5 * 2 * std::numbers::pi * euler_bernoulli(), high = 2.1 * low;
  const double sign = closure(*this, low);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (closure(*this, middle) * sign > 0 ? low : high) = middle;
  }
  return low / (2 * std::numbers::pi);
}

double Cantilever::deflection() const {
  return std::pow(length, 4) / (8 * rigidity()) + length * length / (2 * shear_stiffness(*this));
}

}  // namespace cosurge
