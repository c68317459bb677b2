#include "coupler/schemes/strong/strong.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/piston_run.hpp"

namespace cosurge {
namespace {

using testing::Piston;
using testing::PistonRun;

v1::Coupling strong(v1::Iteration::Relaxation relaxation) {
  v1::Coupling coupling;
  coupling.set_scheme(v1::Coupling::strong);
  coupling.mutable_iteration()->set_relaxation(relaxation);
  return coupling;
}

/// Added mass `ratio` times the piston's; wet period of 0.63 s at 4 windows more than a hundred.
Piston piston_of(double ratio) {
  return {.mass = 500 / ratio, .stiffness = 100 * (500 + 500 / ratio), .substeps = 20};
}

class Relaxations : public ::testing::TestWithParam<v1::Iteration::Relaxation> {};

TEST_P(Relaxations, KeepTheFrequencyOfAPistonFiftyTimesLighterThanItsWater) {
  const Piston piston = piston_of(50);
  v1::Coupling coupling = strong(GetParam());
  coupling.set_velocity(v1::Coupling::end);
  coupling.mutable_iteration()->set_factor(0.03);  // constant: below 2 / (1 + mu)
  coupling.mutable_iteration()->set_limit(500);
  PistonRun run(piston, coupling, 6e-3);
  run.run(1000);
  // 105 windows a period: 0.76 %, a quarter with half the window (docs/tables/coupling_theory.csv).
  EXPECT_NEAR(run.frequency(), piston.wet_frequency(), 1e-2 * piston.wet_frequency());
  EXPECT_EQ(run.coupler->unconverged(), 0U);
}

TEST_P(Relaxations, GoOnBitForBitFromASavedState) {
  v1::Coupling coupling = strong(GetParam());
  coupling.set_prediction(v1::Coupling::extrapolated);
  PistonRun whole(piston_of(3), coupling), first(piston_of(3), coupling), second(piston_of(3), coupling);
  whole.run(60);
  first.run(30);
  second.coupler->restore(first.coupler->save());
  second.run(30);
  EXPECT_EQ(second.coupler->save(), whole.coupler->save());
}

TEST_P(Relaxations, NeedOneIterationAndDivideByNothingWhereNothingMoves) {
  Piston still = piston_of(3);
  still.gravity = 0;
  PistonRun run(still, strong(GetParam()));
  run.run(5);
  EXPECT_EQ(run.value("iterations"), 1);
  EXPECT_EQ(run.value("residual"), 0);
  EXPECT_EQ(run.history.pressure.back(), 0);
}

INSTANTIATE_TEST_SUITE_P(All, Relaxations,
                         ::testing::Values(v1::Iteration::constant, v1::Iteration::aitken,
                                           v1::Iteration::iqn_ils),
                         [](const auto& choice) { return v1::Iteration::Relaxation_Name(choice.param); });

TEST(ConstantRelaxation, ConvergesUpToItsLimitAndNoFurther) {
  // 0 < omega < 2 / (1 + mu): with omega = 0.5 up to mu = 3.
  v1::Coupling coupling = strong(v1::Iteration::constant);
  coupling.set_velocity(v1::Coupling::end);
  coupling.mutable_iteration()->set_factor(0.5);
  coupling.mutable_iteration()->set_limit(1000);
  for (const double ratio : {2.9, 3.1}) {
    Piston piston = piston_of(ratio);
    piston.stiffness = 0;
    PistonRun run(piston, coupling);
    run.run(3);
    EXPECT_EQ(run.coupler->unconverged(), ratio < 3 ? 0U : 3U) << ratio;
  }
}

TEST(StrongCoupling, FindsAddedMassRatioAndSolutionOfOneUnknownInThreeIterations) {
  // There both are the secant method: two iterations to know the line, one to hit its zero.
  for (const auto relaxation : {v1::Iteration::aitken, v1::Iteration::iqn_ils}) {
    v1::Coupling coupling = strong(relaxation);
    coupling.set_velocity(v1::Coupling::end);
    Piston piston = piston_of(7);
    piston.stiffness = 0;
    PistonRun run(piston, coupling);
    run.run(1);
    EXPECT_EQ(run.value("iterations"), 3);
    EXPECT_NEAR(run.value("added_mass_ratio"), 7, 1e-9);  // rounding
    // The piston falls with its water: no pressure but gravity's that the mass lacks.
    EXPECT_NEAR(run.history.pressure.back(), 500 * 9.81 / (1 + 7.0), 1e-6);
  }
}

TEST(StrongCoupling, ReuseOfPastWindowsSavesIterations) {
  const auto iterations = [](int reuse) {
    v1::Coupling coupling = strong(v1::Iteration::iqn_ils);
    coupling.mutable_iteration()->set_reuse(reuse);
    PistonRun run(piston_of(7), coupling);
    double sum = 0;
    for (int k = 0; k < 50; ++k) {
      run.run(1);
      sum += run.value("iterations");
    }
    return sum / 50;
  };
  EXPECT_NEAR(iterations(0), 3, 0.1);
  EXPECT_NEAR(iterations(5), 2, 0.2);  // the first windows have nothing to reuse
}

TEST(StrongCoupling, TakesTheNearestIterationAndCountsTheWindowWhereTheLimitIsReached) {
  v1::Coupling coupling = strong(v1::Iteration::constant);
  coupling.mutable_iteration()->set_factor(0.01);
  coupling.mutable_iteration()->set_limit(4);
  PistonRun run(piston_of(1), coupling);
  run.run(10);
  EXPECT_EQ(run.value("iterations"), 4 + 1);  // once more, with the velocity that was nearest
  EXPECT_GT(run.value("residual"), 1e-3);
  EXPECT_EQ(run.value("unconverged"), 10);
}

TEST(StrongCoupling, OfTheMeanVelocityUnderARampIsUnstableBeyondARatioOfThree) {
  // Solved exactly in each window; yet the new load causes a sixth of the change of the mean velocity.
  const auto growth = [](double ratio) {
    v1::Coupling coupling = strong(v1::Iteration::iqn_ils);
    coupling.set_load(v1::Coupling::ramped);
    coupling.mutable_iteration()->set_tolerance(1e-9);
    PistonRun run({.mass = 500 / ratio, .stiffness = 0, .substeps = 400}, coupling);
    run.run(400);
    const auto change = [&](std::size_t k) {
      return std::abs(run.history.pressure.at(k) - run.history.pressure.at(k - 1));
    };
    return change(399) / change(5);
  };
  EXPECT_LT(growth(2.9), 0.1);
  EXPECT_GT(growth(3.1), 10);
}

TEST(StrongCoupling, CreatesNoEnergyAtTheInterface) {
  // The water has used the resulting motion, to the tolerance. With the mean velocity both works are computed
  // for the same load and the same displacement.
  PistonRun run(piston_of(5), strong(v1::Iteration::iqn_ils));
  run.run(1000);
  double gross = 0, before = 0;
  for (const std::vector<double>& values : run.history.coupling) {
    gross += std::abs(values.at(0) - before);
    before = values.at(0);
  }
  EXPECT_GT(gross, 0);
  EXPECT_LT(std::abs(run.value("work_created")), 1e-3 * gross);
}

v1::Coupling strong_inertial() {
  v1::Coupling coupling = strong(v1::Iteration::iqn_ils);
  coupling.set_scheme(v1::Coupling::strong_inertial);
  return coupling;
}

TEST(StrongInertial, NeedsOneIterationWhereTheModesTellAll) {
  v1::Coupling coupling = strong_inertial();
  coupling.set_velocity(v1::Coupling::end);
  for (const double ratio : {0.1, 1.0, 50.0, 1000.0}) {
    Piston piston = piston_of(ratio);
    piston.substeps = 1;  // symplectic Euler then answers a load by dt / m exactly
    piston.tells_mode = true;
    PistonRun run(piston, coupling, 6e-3);
    run.run(1000);
    // 105 windows a period, as without modes.
    EXPECT_NEAR(run.frequency(), piston.wet_frequency(), 1e-2 * piston.wet_frequency()) << ratio;
    EXPECT_EQ(run.value("iterations"), 1) << ratio;
    EXPECT_EQ(run.coupler->unconverged(), 0U) << ratio;
  }
}

TEST(StrongInertial, FindsWhatStrongFindsWhateverTheModesSay) {
  // The mean velocity over many sub-steps responds by half of what the mode predicts.
  for (const double ratio : {0.5, 7.0}) {
    Piston piston = piston_of(ratio);
    piston.tells_mode = true;
    v1::Coupling with = strong_inertial(), without = strong(v1::Iteration::iqn_ils);
    for (v1::Coupling* coupling : {&with, &without}) coupling->mutable_iteration()->set_tolerance(1e-10);
    PistonRun a(piston, with), b(piston, without);
    a.run(200);
    b.run(200);
    for (std::size_t k = 0; k < a.history.pressure.size(); ++k)
      ASSERT_NEAR(a.history.pressure[k], b.history.pressure[k], 1e-4)  // 5 kPa, after 200 tolerances
          << "window " << k << ", ratio " << ratio;
  }
}

TEST(StrongInertial, GoesOnBitForBitFromASavedState) {
  Piston piston = piston_of(3);
  piston.tells_mode = true;
  PistonRun whole(piston, strong_inertial()), first(piston, strong_inertial()),
      second(piston, strong_inertial());
  whole.run(60);
  first.run(30);
  second.coupler->restore(first.coupler->save());
  second.run(30);
  EXPECT_EQ(second.coupler->save(), whole.coupler->save());
}

}  // namespace
}  // namespace cosurge
