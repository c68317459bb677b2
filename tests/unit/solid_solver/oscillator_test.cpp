#include "solid_solver/oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cosurge {
namespace {

TEST(Stumpff, SeriesAndClosedFormMeet) {
  for (const double x : {0.25, 1 - 1e-12, 1.0, 9.0}) {
    const auto c = stumpff(x);
    const long double w = std::sqrt(static_cast<long double>(x));
    EXPECT_NEAR(c[0], static_cast<double>(std::cos(w)), 1e-15);
    EXPECT_NEAR(c[1], static_cast<double>(std::sin(w) / w), 1e-15);
    EXPECT_NEAR(c[2], static_cast<double>((1 - std::cos(w)) / (w * w)), 1e-15);
    EXPECT_NEAR(c[3], static_cast<double>((w - std::sin(w)) / (w * w * w)), 1e-15);
    EXPECT_NEAR(c[4], static_cast<double>((w * w / 2 - 1 + std::cos(w)) / (w * w * w * w)), 1e-15);
  }
}

/// The same step by many of Verlet's, the damper taken half before and half after: second order.
OscillatorState by_verlet(double omega_squared, double damping, double first, double last, double h,
                          OscillatorState state) {
  const int steps = 400'000;
  const double dt = h / steps, decay = std::exp(-0.5 * damping * dt);
  auto& [x, v, z] = state;
  const auto pull = [&](double s) { return first + s * (last - first) - omega_squared * x; };
  for (int k = 0; k < steps; ++k) {
    v = decay * v + 0.5 * dt * pull(static_cast<double>(k) / steps);
    x += dt * v;
    z += (k + 0.5) / steps * dt * v;
    v = decay * (v + 0.5 * dt * pull((k + 1.0) / steps));
  }
  return state;
}

TEST(OscillatorStep, OneIsManyOfAnyOtherMethod) {
  // No damper, a weak one, twice the critical one, and one with no spring.
  for (const auto& [omega_squared, damping] : {std::pair(30.0, 0.0), {30.0, 0.5}, {30.0, 22.0}, {0.0, 3.0}}) {
    const double first = 2, last = -5, h = 0.7;
    const OscillatorState start{.position = 0.3, .velocity = -1.1};
    OscillatorState exact = start;
    OscillatorStep(omega_squared, damping, h).advance(exact, first, last);
    const OscillatorState many = by_verlet(omega_squared, damping, first, last, h, start);
    // (omega dt)^2 / 24 = 4e-12, (damping dt)^2 / 12 = 1e-10 of a motion of one.
    EXPECT_NEAR(exact.position, many.position, 1e-9) << damping;
    EXPECT_NEAR(exact.velocity, many.velocity, 1e-9) << damping;
    EXPECT_NEAR(exact.ramp_increment, many.ramp_increment, 1e-9) << damping;
  }
}

TEST(OscillatorStep, WithoutASpringItFalls) {
  OscillatorState free{.position = 1, .velocity = 2};
  OscillatorStep(0, 0, 0.5).advance(free, 3, 3);
  EXPECT_NEAR(free.position, 1 + 2 * 0.5 + 3 * 0.125, 1e-15);
  EXPECT_NEAR(free.velocity, 3.5, 1e-15);
  EXPECT_NEAR(free.ramp_increment, 2 * 0.25 + 3 * 0.125 * 2 / 3, 1e-15);  // integral of t / h (2 + 3 t) dt
}

TEST(OscillatorStep, AFaintDamperIsNearlyNone) {
  // Two ways to the same numbers: the exponential of a matrix, and functions of Stumpff; up to 300 rad a
  // step.
  for (const double h : {1e-3, 0.1, 3.0}) {
    OscillatorState none{.position = 0.3, .velocity = -1.1}, faint = none;
    OscillatorStep(1e4, 0, h).advance(none, 2, -5);
    OscillatorStep(1e4, 1e-14, h).advance(faint, 2, -5);
    EXPECT_NEAR(faint.position, none.position, 1e-12) << h;  // rounding of 300 rad, 1e-13
    EXPECT_NEAR(faint.velocity, none.velocity, 1e-10) << h;  // a hundred times the position
    EXPECT_NEAR(faint.ramp_increment, none.ramp_increment, 1e-12) << h;
  }
}

}  // namespace
}  // namespace cosurge
