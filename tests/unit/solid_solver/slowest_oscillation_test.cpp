// The frequency that the solid tells the water, against beams and springs.
#include "solid_solver/slowest_oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/loaded_solid.hpp"

namespace cosurge {
namespace {

using test::l0;

/// sqrt(E I / rho A) / L^2 [1/s] of a plate of 8 mm by 160 mm, E = 1 MPa: times 3.516 the first frequency of
/// a cantilever, times 22.37 that of a free beam (Euler and Bernoulli).
const double beam = 0.008 * std::sqrt(1e6 / (12 * 2500)) / (0.16 * 0.16);

double frequency_of(const v1::Case& c) {
  test::LoadedSolid run(c, test::left_face(20));
  return run.motion.frequency;
}

class SlowestOscillation : public ::testing::TestWithParam<v1::SolidModel::Word> {};

TEST_P(SlowestOscillation, IsThatOfTheBeam) {
  for (const auto& [clamped, factor] : {std::pair{true, 3.516}, std::pair{false, 22.37}}) {
    v1::Case c = test::plate({.columns = 8, .rows = 160, .clamped = clamped});
    c.mutable_solid()->set_model(GetParam());
    EXPECT_NEAR(frequency_of(c) / (factor * beam), 1, 0.02) << factor;  // shear and rotation: 0.2 and 1 %
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SlowestOscillation,
                         ::testing::Values(v1::SolidModel::mps, v1::SolidModel::hamiltonian,
                                           v1::SolidModel::fem, v1::SolidModel::modal),
                         [](const auto& model) { return v1::SolidModel::Word_Name(model.param); });

TEST(SlowestOscillationOf, ABodyOnSpringsIsItsFastestAndOfARigidOneZero) {
  v1::Case c = test::plate({.rows = 20, .clamped = false});
  c.mutable_solid()->set_model(v1::SolidModel::sprung);
  const double mass = 2500 * 0.012 * 0.020;
  for (const auto& [motion, omega] : {std::pair{v1::Spring::x, 30.0}, std::pair{v1::Spring::y, 50.0}}) {
    v1::Spring& spring = *c.mutable_solid()->mutable_sprung()->add_spring();
    spring.set_motion(motion);
    spring.set_stiffness(mass * omega * omega);
  }
  EXPECT_NEAR(frequency_of(c), 50, 1e-9);
  c.mutable_solid()->set_model(v1::SolidModel::rigid);
  EXPECT_EQ(frequency_of(c), 0);
}

TEST(SlowestOscillationOf, SeveralBodiesIsTheHighest) {
  v1::Case c = test::plate({.columns = 8, .rows = 160});
  c.mutable_solid()->set_model(v1::SolidModel::fem);
  v1::Body& shorter = *c.mutable_solid()->add_body();
  test::set_box(*shorter.mutable_box(), {0.1, 0}, {0.108, 0.08});
  test::set_box(*shorter.add_clamp(), {0.1, -0.02}, {0.108, 0});
  EXPECT_NEAR(frequency_of(c) / (4 * 3.516 * beam), 1, 0.02);
}

TEST(SlowestOscillationOf, AStructureLimitsWindowsWhereTheCaseDoesNot) {
  v1::Case c = test::plate({.columns = 8, .rows = 160});
  c.mutable_solid()->set_model(v1::SolidModel::fem);
  EXPECT_EQ(test::LoadedSolid(c, test::left_face(20)).setup.window, std::numeric_limits<double>::infinity());
  c.mutable_time()->clear_window();
  test::LoadedSolid run(c, test::left_face(20));
  const double period = 2 * std::numbers::pi / (3.516 * beam);
  EXPECT_NEAR(50 * run.setup.window / period, 1, 0.02);
  EXPECT_EQ(run.advance(1e-4).window, run.setup.window);
  run.load.force = test::load_of(0, 20);
  EXPECT_NEAR(200 * run.advance(1e-4).window / period, 1, 0.02);
}

}  // namespace
}  // namespace cosurge
