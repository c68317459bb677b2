// Where weak coupling is stable, on the piston without a spring: the exact limits of docs/method.md,
// section 3.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/piston_run.hpp"

namespace cosurge {
namespace {

using testing::Piston;
using testing::PistonRun;

/// How a weak scheme exchanges, and the largest stable ratio of added mass to mass.
struct Limit {
  std::string name;
  v1::Coupling::LoadPath load;
  v1::Coupling::Velocity velocity;
  v1::Coupling::Prediction prediction;
  int substeps;
  double critical;
};

class WeakCoupling : public ::testing::TestWithParam<Limit> {
 protected:
  PistonRun run(double ratio) const {
    const Limit& limit = GetParam();
    v1::Coupling coupling;
    coupling.set_scheme(v1::Coupling::weak);
    coupling.set_load(limit.load);
    coupling.set_velocity(limit.velocity);
    coupling.set_prediction(limit.prediction);
    return {Piston{.mass = 500 / ratio, .stiffness = 0, .substeps = limit.substeps}, coupling};
  }

  /// Change of the pressure from window to window, late over early: the pressure of a free fall is constant.
  double growth(double ratio) const {
    PistonRun piston = run(ratio);
    piston.run(1000);
    const auto swing = [&](std::size_t from) {
      double largest = 0;
      for (std::size_t k = from; k < from + 20; ++k)
        largest =
            std::max(largest, std::abs(piston.history.pressure.at(k) - piston.history.pressure.at(k - 1)));
      return largest;
    };
    return swing(975) / swing(5);
  }
};

TEST_P(WeakCoupling, IsStableJustBelowItsLimitAndUnstableJustAbove) {
  // 2 % off, the alternation changes by about 1 % or 2 % a window: a factor of some 1e4 in 970 windows.
  EXPECT_LT(growth(0.98 * GetParam().critical), 0.1);
  EXPECT_GT(growth(1.02 * GetParam().critical), 10);
}

using C = v1::Coupling;
// Limits from the spectral radius of the update (docs/method.md, table of section 3). Last two rows: with the
// mean velocity of n sub-steps of symplectic Euler the limit is 2 n / (n - 1); with a ramp and many sub-steps
// 3 / 2.
INSTANTIATE_TEST_SUITE_P(
    Limits, WeakCoupling,
    ::testing::Values(Limit{"HeldEnd", C::held, C::end, C::last, 10, 1.0},
                      Limit{"HeldEndOneSubstep", C::held, C::end, C::last, 1, 1.0},
                      Limit{"HeldMeanOneSubstep", C::held, C::mean, C::last, 1, 1.0},
                      Limit{"HeldEndExtrapolated", C::held, C::end, C::extrapolated, 10, 1.0 / 3},
                      Limit{"RampedEnd", C::ramped, C::end, C::last, 10, 2.0},
                      Limit{"RampedEndExtrapolated", C::ramped, C::end, C::extrapolated, 10, 0.869},
                      Limit{"HeldMean", C::held, C::mean, C::last, 10, 20.0 / 9},
                      Limit{"RampedMean", C::ramped, C::mean, C::last, 400, 1.5}),
    [](const auto& choice) { return choice.param.name; });

TEST(WeakRatio, IsFoundFromTheChangesOfAccelerationWhereTheLoadRules) {
  v1::Coupling coupling;
  coupling.set_scheme(v1::Coupling::weak);
  coupling.set_velocity(v1::Coupling::end);
  for (const double ratio : {0.4, 0.9, 1.2}) {
    PistonRun piston(Piston{.mass = 500 / ratio, .stiffness = 0}, coupling);
    piston.run(60);
    EXPECT_NEAR(piston.value("added_mass_ratio"), ratio, 1e-6 * ratio);  // exact but for rounding
  }
}

TEST(WeakAccount, SaysThatTheSchemeCreatesEnergyWhereItIsUnstable) {
  v1::Coupling coupling;
  coupling.set_scheme(v1::Coupling::weak);
  coupling.set_velocity(v1::Coupling::end);
  PistonRun piston(Piston{.mass = 500 / 1.1, .stiffness = 0}, coupling);
  piston.run(100);
  const double early = piston.value("work_created");
  piston.run(100);
  // 1.1 per window, twice for energy.
  EXPECT_GT(piston.value("work_created"), 1e6 * std::abs(early));
}

}  // namespace
}  // namespace cosurge
