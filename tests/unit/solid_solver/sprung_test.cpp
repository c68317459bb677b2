#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "common/vec.hpp"
#include "tests/support/loaded_solid.hpp"

namespace cosurge::sprung {
namespace {

using test::l0;
using test::LoadedSolid;

constexpr double mass = 2500 * 0.012 * 0.020;  // mass of the block below

void add_spring(v1::Case& c, v1::Spring::Motion motion, double stiffness, double damping = 0) {
  v1::Spring& spring = *c.mutable_solid()->mutable_sprung()->add_spring();
  spring.set_motion(motion);
  spring.set_stiffness(stiffness);
  spring.set_damping(damping);
}

/// A block of 12 x 20 mm without springs.
v1::Case block(const std::vector<double>& gravity = {0, 0}) {
  v1::Case c = test::plate({.rows = 20, .clamped = false, .gravity = gravity});
  c.mutable_solid()->set_model(v1::SolidModel::sprung);
  return c;
}

double sum_of(const LoadedSolid& run, const Report& report) {
  return run.value(report, "kinetic_energy") + run.value(report, "elastic_energy") +
         run.value(report, "gravity_energy");
}

TEST(Sprung, SwingsAtItsFrequencyWhateverTheWindow) {
  const double frequency = 3, omega = 2 * std::numbers::pi * frequency;
  v1::Case c = block();
  add_spring(c, v1::Spring::x, mass * omega * omega);
  LoadedSolid run(c, test::left_face(20));
  run.load.force.row(0).setConstant(5. / 20);
  const double deflection = 5 / (mass * omega * omega);
  for (int k = 1; k <= 7; ++k) {
    const Report report = run.advance(0.11);  // a third of a period
    EXPECT_NEAR(run.value(report, "tip_x") / deflection, 1 - std::cos(omega * 0.11 * k), 1e-13);
    EXPECT_EQ(run.value(report, "tip_y"), 0);
    EXPECT_EQ(run.value(report, "substeps"), 1);
  }
}

TEST(Sprung, ADamperTakesItsShareOfEverySwing) {
  const double omega = 20, ratio = 0.05;
  v1::Case c = block();
  add_spring(c, v1::Spring::y, mass * omega * omega, 2 * ratio * mass * omega);
  LoadedSolid run(c, test::left_face(20));
  run.load.force.row(1).setConstant(1);
  run.advance(10);  // to rest: exp(-0.05 20 10) = 5e-5
  run.load.force.setZero();
  const double period = 2 * std::numbers::pi / (omega * std::sqrt(1 - ratio * ratio));
  const double first = run.value(run.advance(period), "tip_y"),
               second = run.value(run.advance(period), "tip_y");
  // The rest of the first oscillation changes the ratio by 5e-5 at most.
  EXPECT_NEAR(std::log(first / second) / (ratio * omega * period), 1, 1e-4);
}

TEST(Sprung, APreloadHoldsTheBodyAgainstItsWeight) {
  v1::Case c = block({0, -9.81});
  add_spring(c, v1::Spring::y, 500);
  c.mutable_solid()->mutable_sprung()->mutable_spring(0)->set_preload(9.81 * mass);
  LoadedSolid run(c, {});
  EXPECT_NEAR(run.value(run.advance(0.3), "tip_y"), 0, 1e-15);
  c.mutable_solid()->mutable_sprung()->mutable_spring(0)->set_preload(0);
  LoadedSolid falls(c, {});
  const double half_period = std::numbers::pi * std::sqrt(mass / 500);
  EXPECT_NEAR(falls.value(falls.advance(half_period), "tip_y") / (-2 * 9.81 * mass / 500), 1, 1e-12);
}

TEST(Sprung, MassOfTheCaseGoesBeforeDensity) {
  v1::Case c = block();
  add_spring(c, v1::Spring::y, 0);
  c.mutable_solid()->mutable_sprung()->set_mass(3);
  LoadedSolid run(c, test::left_face(20));
  run.load.force.row(1).setConstant(6. / 20);
  EXPECT_NEAR(run.value(run.advance(0.5), "tip_y"), 0.5 * 2 * 0.25, 1e-14);  // g t^2 / 2 with 6 N on 3 kg
}

TEST(Sprung, ADiscTurnsThroughManyTurnsAndKeepsItsEnergy) {
  v1::Case c = block();
  for (const auto motion : {v1::Spring::x, v1::Spring::y, v1::Spring::turn}) add_spring(c, motion, 0);
  for (const auto path : {v1::Coupling::held, v1::Coupling::ramped}) {
    c.mutable_coupling()->set_load(path);
    LoadedSolid run(c, test::left_face(20));
    double most = 0;
    for (int k = 0; k < 200; ++k) {
      run.load.force = 10 * test::load_of(k / 40, 20);
      const Report report = run.advance(1e-3);
      const double work = run.value(report, "interface_work");
      most = std::max(most, std::abs(work));
      // Exact but for rounding, for any angle: the mid-point rule with the mean moment.
      EXPECT_NEAR(sum_of(run, report), work, 1e-12 * most);
    }
    EXPECT_GT(most, 0.1);
  }
}

TEST(Sprung, APendulumOfLargeSwingHasThePeriodOfTheEllipticIntegral) {
  v1::Case c = block({3, -4});  // 5 m/s2, along (0.6, -0.8)
  add_spring(c, v1::Spring::turn, 0);
  for (const double x : {0.006, 0.0})
    c.mutable_solid()->mutable_sprung()->add_pivot(x);  // hinged at its foot
  LoadedSolid run(c, {});
  // The block stands up from the hinge: its angle to the hanging rest is 180 - atan(3 / 4) = 143.13 degrees.
  const double start = std::numbers::pi - std::atan2(3, 4), arm = 0.010;
  const double inertia = mass * ((0.012 * 0.012 + 0.020 * 0.020) / 12 + arm * arm);
  const double period = 4 * std::sqrt(inertia / (mass * 5 * arm)) * std::comp_ellint_1(std::sin(start / 2));
  const int windows = 2000;
  Report report;
  for (int k = 0; k < windows / 2; ++k) report = run.advance(period / windows);
  // At the other end of the swing the tip (6, 20 mm from the hinge) is turned by -2 start; second order:
  // 1e-5.
  const double turned = -2 * start;
  EXPECT_NEAR(run.value(report, "tip_x"), std::cos(turned) * 0.006 - std::sin(turned) * 0.020 - 0.006, 1e-6);
  EXPECT_NEAR(run.value(report, "tip_y"), std::sin(turned) * 0.006 + std::cos(turned) * 0.020 - 0.020, 1e-6);
  EXPECT_LT(run.value(report, "max_speed"), 0.01);
}

TEST(Sprung, AFlapOnItsHingeTurnsUnderPressureAndDoesTheSameWorkOnBothSides) {
  v1::Case c = block();
  add_spring(c, v1::Spring::turn, 0.02, 1e-5);
  for (const double x : {0.006, 0.0}) c.mutable_solid()->mutable_sprung()->add_pivot(x);
  c.mutable_coupling()->set_load(v1::Coupling::ramped);
  LoadedSolid run(c, test::left_face(20));
  Field last_load = Field::Zero(2, 20);
  double at_points = 0, gross = 0, on_nodes = 0, furthest = 0;
  for (int k = 0; k < 100; ++k) {
    const Field before = run.motion.displacement, load = test::load_of(k / 25, 20);
    run.load.force = load;
    const Report report = run.advance(1e-3);
    const double work = last_load.cwiseProduct(run.motion.displacement - before).sum() +
                        (load - last_load).cwiseProduct(run.motion.ramp_increment).sum();
    at_points += work;
    gross += std::abs(work);
    on_nodes = run.value(report, "interface_work");
    furthest = std::max(furthest, std::abs(run.value(report, "tip_x")));
    last_load = load;
  }
  EXPECT_GT(furthest, 0.002);
  EXPECT_NEAR(at_points, on_nodes, 1e-12 * gross);
  // Every point keeps its distance from the hinge.
  for (int j = 0; j < 20; ++j) {
    const Vec<2> X = run.interface.position.col(j), x = X + run.motion.displacement.col(j), hinge(0.006, 0);
    EXPECT_NEAR((x - hinge).norm(), (X - hinge).norm(), 1e-15);
  }
}

TEST(Sprung, SavedStateContinuesBitForBit) {
  v1::Case c = block();
  for (const auto motion : {v1::Spring::x, v1::Spring::y, v1::Spring::turn}) add_spring(c, motion, 0.1, 1e-4);
  c.mutable_coupling()->set_load(v1::Coupling::ramped);
  LoadedSolid run(c, test::left_face(20)), other(c, test::left_face(20));
  const auto advance = [](LoadedSolid& r, int from, int to) {
    for (int k = from; k < to; ++k) {
      r.load.force = test::load_of(k, 20);
      r.advance(1e-4);
    }
  };
  advance(run, 0, 5);
  other.solid.restore(run.solid.save());
  advance(run, 5, 10);
  advance(other, 5, 10);
  EXPECT_TRUE((run.motion.displacement.array() == other.motion.displacement.array()).all());
  EXPECT_TRUE((run.motion.velocity.array() == other.motion.velocity.array()).all());
  EXPECT_TRUE((run.motion.ramp_increment.array() == other.motion.ramp_increment.array()).all());
}

TEST(Sprung, ABrickInSpaceMovesAlongItsSpringsOnly) {
  v1::Case c;
  c.set_dimension(3);
  for (const double g : {0.0, 0.0, -9.81}) c.add_gravity(g);
  v1::Solid& solid = *c.mutable_solid();
  solid.set_model(v1::SolidModel::sprung);
  solid.set_spacing(0.01);
  solid.set_density(500);
  test::set_box(*solid.add_body()->mutable_box(), {0, 0, 0}, {0.1, 0.2, 0.04});
  add_spring(c, v1::Spring::z, 100);  // 0.4 kg
  LoadedSolid run(c, {});
  run.advance(std::numbers::pi * std::sqrt(0.4 / 100));
  const Snapshot frame = run.solid.frame();
  EXPECT_EQ(run.setup.particles, 800u);
  EXPECT_FLOAT_EQ(frame[0].values[0], 0.005f);
  EXPECT_FLOAT_EQ(frame[0].values[1], 0.005f);
  EXPECT_FLOAT_EQ(frame[0].values[2], static_cast<float>(0.005 - 2 * 9.81 * 0.4 / 100));
}

TEST(Sprung, ABodyThatMovesTurnsAboutItsCentreOfMassOnly) {
  v1::Case swinging = block();
  add_spring(swinging, v1::Spring::turn, 1);
  for (const double x : {0.006, 0.0}) swinging.mutable_solid()->mutable_sprung()->add_pivot(x);
  EXPECT_NO_THROW(LoadedSolid(swinging, {}));
  add_spring(swinging, v1::Spring::x, 1);  // turning about a point that moves
  EXPECT_THROW(LoadedSolid(swinging, {}), Error);
}

TEST(Sprung, LoadsThatAreNoNumbersEndTheRun) {
  v1::Case c = block();
  add_spring(c, v1::Spring::y, 1);
  LoadedSolid run(c, test::left_face(20));
  run.load.force.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(run.advance(1e-4), NumericalError);
}

}  // namespace
}  // namespace cosurge::sprung
