#include "solid_solver/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace cosurge {
namespace {

/// Rows: end, velocity, mean of the position; columns: position, velocity, first, last.
using Rows = Eigen::Matrix<double, 3, 4>;

Rows undamped(double omega_squared, double h) {
  const std::array<double, 5> c = stumpff(omega_squared * h * h);
  Rows rows;
  rows << c[0], h * c[1], h * h * (c[2] - c[3]), h * h * c[3],       //
      -omega_squared * h * c[1], c[0], h * (c[1] - c[2]), h * c[2],  //
      c[1], h * c[2], h * h * (c[3] - c[4]), h * h * c[4];
  return rows;
}

/// Step by the matrix exponential of the system in the time t / h. Unknowns: position, h / g times the
/// velocity, integral of the position, h^2 / g times the load and its change. g makes the matrix no larger
/// than w = omega h.
Rows damped(double omega_squared, double damping, double h) {
  const double w_squared = omega_squared * h * h, g = std::max(1.0, std::sqrt(w_squared));
  Eigen::Matrix<double, 5, 5> A = Eigen::Matrix<double, 5, 5>::Zero();
  A(0, 1) = g;
  A(1, 0) = -w_squared / g;
  A(1, 1) = -damping * h;
  A(1, 3) = 1;
  A(2, 0) = 1;
  A(3, 4) = 1;
  const Eigen::Matrix<double, 5, 5> E = A.exp();
  const double v = h / g, p = h * h / g;
  Rows rows;
  for (int i = 0; i < 3; ++i) rows.row(i) << E(i, 0), E(i, 1) * v, (E(i, 3) - E(i, 4)) * p, E(i, 4) * p;
  rows.row(1) /= v;
  return rows;
}

}  // namespace

std::array<double, 5> stumpff(double x) {
  std::array<double, 5> c;
  if (x < 1) {
    // The last term left out is below 1 / 20!.
    constexpr int terms = 9;
    double factorial = 1;
    for (int k = 0; k < 5; ++k) {
      factorial *= std::max(1, k);
      double term = 1 / factorial;
      c[k] = 0;
      for (int j = 1; j <= terms; ++j) {
        c[k] += term;
        term *= -x / ((k + 2 * j - 1) * (k + 2 * j));
      }
    }
    return c;
  }
  const double w = std::sqrt(x);
  c[0] = std::cos(w);
  c[1] = std::sin(w) / w;
  c[2] = (1 - c[0]) / x;
  c[3] = (1 - c[1]) / x;
  c[4] = (0.5 - c[2]) / x;
  return c;
}

OscillatorStep::OscillatorStep(double omega_squared, double damping, double h)
    : step_(damping > 0 ? damped(omega_squared, damping, h) : undamped(omega_squared, h)) {
  step_.row(2) = step_.row(0) - step_.row(2);  // integral of s d eta = end - mean
}

void OscillatorStep::advance(OscillatorState& state, double first, double last) const {
  const Eigen::Vector3d next = step_ * Eigen::Vector4d(state.position, state.velocity, first, last);
  state = {.position = next[0], .velocity = next[1], .ramp_increment = next[2]};
}

}  // namespace cosurge
