#include "coupler/schemes/weak_inertial.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/piston_run.hpp"

namespace cosurge {
namespace {

using testing::Piston;
using testing::PistonRun;

v1::Coupling words() {
  v1::Coupling coupling;
  coupling.set_scheme(v1::Coupling::weak_inertial);
  coupling.set_velocity(v1::Coupling::end);
  return coupling;
}

Piston piston_of(double ratio) {
  return {.mass = 500 / ratio, .stiffness = 100 * (500 + 500 / ratio), .substeps = 1, .tells_mode = true};
}

TEST(WeakInertial, KeepsTheFrequencyOfAPistonInWaterOfAnyWeight) {
  for (const double ratio : {0.1, 1.0, 50.0, 1000.0}) {
    const Piston piston = piston_of(ratio);
    PistonRun run(piston, words(), 6e-3);
    run.run(2000);
    // 105 windows a period: up to 0.8 %, a quarter with half the window (docs/tables/coupling_theory.csv).
    EXPECT_NEAR(run.frequency(), piston.wet_frequency(), 1e-2 * piston.wet_frequency()) << ratio;
    EXPECT_EQ(run.value("iterations"), 1);
  }
}

TEST(WeakInertial, KnowsTheMotionThatComesOut) {
  // One sub-step of symplectic Euler answers a load by dt / m exactly.
  PistonRun run(piston_of(7), words());
  run.run(20);
  EXPECT_LT(run.value("residual"), 1e-12);  // rounding
}

TEST(WeakInertial, WithoutModesIsAsUnstableAsWeakAfterAPrediction) {
  Piston silent = piston_of(3);
  silent.tells_mode = false;
  silent.stiffness = 0;
  PistonRun run(silent, words());
  run.run(200);
  EXPECT_GT(std::abs(run.history.pressure.back()), 1e6);  // 5 kPa at rest
}

}  // namespace
}  // namespace cosurge
