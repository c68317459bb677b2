// Oscillators, exact in time.
#pragma once

#include <Eigen/Core>
#include <array>

namespace cosurge {

/// Stumpff's functions c_k(x) = sum_j (-x)^j / (k + 2 j)!, k = 0 ... 4, x >= 0: with x = w^2 they are cos w,
/// sin w / w, (1 - cos w) / w^2, (w - sin w) / w^3, (w^2 / 2 - 1 + cos w) / w^4.
std::array<double, 5> stumpff(double x);

/// State of one oscillator.
struct OscillatorState {
  double position = 0;
  double velocity = 0;
  double ramp_increment =
      0;  ///< integral of s d eta over the last step, s = t / h: what a ramped load works on
};

/// One step of eta'' + damping eta' + omega^2 eta = load, with a load per unit of mass that changes linearly
/// from first to last. Exact for any step, damping and stiffness, including zero (docs/method_solid.md, S27).
class OscillatorStep {
 public:
  /// @param omega_squared [1/s2], damping [1/s], h the step [s]; none negative
  OscillatorStep(double omega_squared, double damping, double h);

  void advance(OscillatorState& state, double first, double last) const;

 private:
  Eigen::Matrix<double, 3, 4> step_;  // matrix from (position, velocity, first, last) to the next state
};

}  // namespace cosurge
