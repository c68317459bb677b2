// Undamped oscillators, exact in time.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace cosurge::modal {

/// Stumpff's functions c_k(x) = sum_j (-x)^j / (k + 2 j)!, k = 0 ... 4, x >= 0: with x = w^2 they are cos w,
/// sin w / w, (1 - cos w) / w^2, (w - sin w) / w^3, (w^2 / 2 - 1 + cos w) / w^4.
inline std::array<double, 5> stumpff(double x) {
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

/// eta'' + omega^2 eta = load, a load per unit of mass that goes linearly from first to last over h.
struct Oscillator {
  double position;
  double velocity;

  /// Moves on by h, exactly (docs/method_solid.md, S27), and returns the integral of s d eta, s = t / h,
  /// which a ramped load works on.
  double advance(double omega_squared, double first, double last, double h) {
    const std::array<double, 5> c = stumpff(omega_squared * h * h);
    const double change = last - first;
    const double mean = c[1] * position + h * c[2] * velocity + h * h * (c[3] * first + c[4] * change);
    const double end = c[0] * position + h * c[1] * velocity + h * h * (c[2] * first + c[3] * change);
    velocity = c[0] * velocity - omega_squared * h * c[1] * position + h * (c[1] * first + c[2] * change);
    position = end;
    return end - mean;
  }
};

}  // namespace cosurge::modal
