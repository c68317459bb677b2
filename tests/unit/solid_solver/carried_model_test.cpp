// Bodies whose clamps, supports or springs move as prescribed.
#include "solid_solver/carried_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/case/carriers.hpp"
#include "common/case/from_case.hpp"
#include "common/error.hpp"
#include "common/geometry/motion.hpp"
#include "solid_solver/models/make_model.hpp"
#include "tests/support/contact_scene.hpp"
#include "tests/support/rolling_tank.hpp"
#include "tests/support/structures.hpp"

namespace cosurge {
namespace {

using std::numbers::pi;
using Word = v1::SolidModel;

using test::rolling_tank;

constexpr double dt = test::rolling_window;

template <int dim>
std::unique_ptr<SolidModel> carried(const Structure<dim>& structure) {
  return with_carriers(make_model(structure), structure);
}

std::unique_ptr<SolidModel> make(const v1::Case& c) {
  return c.dimension() == 2 ? carried(structure_from_case<2>(c)) : carried(structure_from_case<3>(c));
}

NodalLoad none(const SolidModel& model, int dim) {
  return {.first = Field::Zero(dim, model.nodes()), .last = Field::Zero(dim, model.nodes())};
}

/// Farthest that a node is from where the tank would carry it [m].
template <int dim>
double strayed(const SolidModel& model, const v1::WallMotion& motion, double t) {
  const auto tank = from_case<dim>(motion);
  const NodeLayout layout = model.layout();
  const Field moved = model.displacement();
  double farthest = 0;
  for (Eigen::Index n = 0; n < model.nodes(); ++n) {
    const Vec<dim> X = layout.position.col(n), x = X + Vec<dim>(moved.col(n));
    farthest = std::max(farthest, (x - tank.place(X, t)).norm());
  }
  return farthest;
}

class Carried : public testing::TestWithParam<Word::Word> {
 protected:
  /// Over a second; with no load but the model's own weight.
  template <int dim>
  double strays(double young_modulus, double gravity) const {
    v1::Case c = rolling_tank<dim>(GetParam(), young_modulus);
    c.set_gravity(dim - 1, gravity);
    if (GetParam() == Word::sprung) {
      v1::Spring& spring = *c.mutable_solid()->mutable_sprung()->add_spring();
      spring.set_motion(v1::Spring::x);
      spring.set_stiffness(young_modulus * 10);
    }
    const auto model = make(c);
    double farthest = 0;
    for (int k = 0; k < 1000; ++k) {
      model->advance({.index = static_cast<std::uint64_t>(k), .start = k * dt, .size = dt},
                     none(*model, dim));
      if (k % 50 == 49)
        farthest = std::max(farthest, strayed<dim>(*model, c.fluid().tank_motion(), (k + 1) * dt));
    }
    return farthest;
  }
};

TEST_P(Carried, AStiffBodyMovesWithTheTank) {
  // Its own weight and inertia bend it by some rho g H^4 / (E h^2) = 2e-3 m / (E / 1e6 Pa) at most.
  if (GetParam() == Word::rigid) {
    EXPECT_LT(strays<2>(1e9, -9.81), 1e-14);
    EXPECT_LT(strays<3>(1e9, -9.81), 1e-14);
    return;
  }
  const double stiff = strays<2>(1e8, -9.81);
  RecordProperty("strayed", fmt::format("{:.3g}", stiff));
  EXPECT_LT(stiff, 1e-4);
  EXPECT_GT(stiff, 1e-9);
}

TEST_P(Carried, InSpaceToo) {
  if (GetParam() == Word::mps || GetParam() == Word::hamiltonian) return;  // slow, and the same code
  EXPECT_LT(strays<3>(1e8, -9.81), 1e-4);
}

TEST_P(Carried, AStateThatIsRestoredGoesOnToTheSameBits) {
  if (GetParam() == Word::sprung) return;
  const v1::Case c = rolling_tank<2>(GetParam(), 1e7);
  const auto one = make(c), other = make(c);
  const auto window = [](int k) {
    return Window{.index = static_cast<std::uint64_t>(k), .start = k * dt, .size = dt};
  };
  for (int k = 0; k < 20; ++k) one->advance(window(k), none(*one, 2));
  other->restore(one->save());
  for (int k = 20; k < 40; ++k) {
    one->advance(window(k), none(*one, 2));
    other->advance(window(k), none(*other, 2));
  }
  EXPECT_EQ(one->displacement(), other->displacement());
  EXPECT_EQ(one->velocity(), other->velocity());
}

INSTANTIATE_TEST_SUITE_P(Models, Carried,
                         testing::Values(Word::mps, Word::hamiltonian, Word::fem, Word::modal, Word::sprung,
                                         Word::rigid),
                         [](const auto& model) { return Word::Word_Name(model.param); });

/// A body on a spring of its own frequency, whose anchor is shaken along x: the relative motion of a shaken
/// oscillator from rest, z'' + w^2 z = -x''.
TEST(CarriedOscillator, FollowsTheSolutionOfAShakenAnchor) {
  v1::Case c = rolling_tank<2>(Word::sprung, 0);
  v1::WallMotion& motion = *c.mutable_fluid()->mutable_tank_motion();
  motion.set_angle(0);
  motion.set_ramp(0);
  const double amplitude = 0.05, shaken = 2 * pi * 0.8;
  v1::Spring& spring = *c.mutable_solid()->mutable_sprung()->add_spring();
  spring.set_motion(v1::Spring::x);
  const double mass = 1500 * 0.04 * 0.12, omega = 2 * pi * 2;
  spring.set_stiffness(mass * omega * omega);
  const auto model = make(c);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    model->advance({.index = static_cast<std::uint64_t>(k), .start = k * dt, .size = dt}, none(*model, 2));
    const double t = (k + 1) * dt;
    // In space: y'' + w^2 y = w^2 a sin(W t), from y = 0 with the velocity of the anchor, y' = a W.
    const double exact =
        amplitude / (omega * omega - shaken * shaken) *
        (omega * omega * std::sin(shaken * t) - shaken * shaken * shaken / omega * std::sin(omega * t));
    worst = std::max(worst, std::abs(model->displacement()(0, 0) - exact));
  }
  RecordProperty("worst", fmt::format("{:.3g}", worst));
  EXPECT_LT(worst, 5e-4 * amplitude);
}

/// A plate whose clamps move at a constant speed from the start: it moves along, without strain.
TEST_P(Carried, ABodyStartsWithTheVelocityOfItsHolder) {
  v1::Case c = rolling_tank<2>(GetParam(), 1e6);
  c.mutable_fluid()->clear_tank_motion();
  c.set_gravity(1, 0);
  v1::WallMotion& motion = *c.mutable_solid()->mutable_body(0)->mutable_motion();
  for (const double value : {0.0, 0.0, 0.0, 0.0, 1.0, 3.0, -4.0, 0.0}) motion.add_row(value);
  const auto model = make(c);
  EXPECT_NEAR(model->velocity()(0, 0), 3, 1e-9);
  EXPECT_NEAR(model->velocity()(1, 0), -4, 1e-9);
  for (int k = 0; k < 50; ++k)
    model->advance({.index = static_cast<std::uint64_t>(k), .start = k * dt, .size = dt}, none(*model, 2));
  const Vec<2> way = 50 * dt * Vec<2>(3, -4);
  for (Eigen::Index n = 0; n < model->nodes(); ++n)
    EXPECT_LT((Vec<2>(model->displacement().col(n)) - way).norm(), 1e-9) << n;
}

/// A body that nothing holds is thrown: a parabola, with the energy of its speed.
TEST_P(Carried, AFreeBodyHasItsInitialVelocity) {
  if (GetParam() == Word::rigid) return;  // it is held
  v1::Case c = rolling_tank<2>(GetParam(), 1e6);
  c.mutable_fluid()->clear_tank_motion();
  v1::Body& body = *c.mutable_solid()->mutable_body(0);
  body.clear_clamp();
  body.add_velocity(2);
  body.add_velocity(-5);
  for (const v1::Spring::Motion along : {v1::Spring::x, v1::Spring::y})
    c.mutable_solid()->mutable_sprung()->add_spring()->set_motion(along);
  const auto model = make(c);
  const double mass = model->inertia(Field::Ones(2, model->nodes())).row(0).sum();
  EXPECT_NEAR(model->energies().kinetic, 0.5 * mass * 29, 1e-9 * mass);
  const double g = -c.gravity(1);
  for (int k = 0; k < 50; ++k)
    model->advance({.index = static_cast<std::uint64_t>(k), .start = k * dt, .size = dt}, none(*model, 2));
  const double t = 50 * dt;
  // The particles of `mps` fall at most g t / 2 times a sub-step farther.
  const Vec<2> way(2 * t, -5 * t - 0.5 * g * t * t);
  for (Eigen::Index n = 0; n < model->nodes(); ++n)
    EXPECT_LT((Vec<2>(model->displacement().col(n)) - way).norm(), 5e-3 * 0.5 * g * t * t + 1e-9) << n;
}

TEST(CarriedBody, TouchesNothingWhereItsTankCarriesIt) {
  test::ContactRun run(rolling_tank<2>(Word::fem, 1e7));
  while (run.windows < 300) {
    run.advance();
    ASSERT_EQ(run.value("contact_points"), 0) << run.windows;
  }
  EXPECT_TRUE(run.notes.empty());
  EXPECT_EQ(run.value("substeps"), 1);
}

TEST(CarriedBody, GoesWithTheObstacleThatItsClampsLieIn) {
  v1::Case c = rolling_tank<2>(Word::rigid, 1e9);
  c.mutable_fluid()->clear_tank_motion();
  v1::Obstacle& obstacle = *c.mutable_fluid()->add_obstacle();
  *obstacle.mutable_shape() = test::box({0.2, -0.1}, {0.4, 0});
  v1::WallMotion& motion = *obstacle.mutable_motion();
  motion.set_angle(0.2);
  motion.set_frequency(1);
  const auto model = make(c);
  model->advance({.index = 0, .start = 0, .size = 0.2}, none(*model, 2));
  EXPECT_LT(strayed<2>(*model, motion, 0.2), 1e-15);
  EXPECT_GT(model->displacement().cwiseAbs().maxCoeff(), 0.01);
  // Its other end in the tank, which stands still.
  *c.mutable_solid()->mutable_body(0)->add_clamp() = test::box({0.28, 0.12}, {0.32, 0.16});
  EXPECT_THROW(static_cast<void>(motion_of(c, c.solid().body(0))), Error);
  c.mutable_solid()->mutable_body(0)->mutable_motion();
  EXPECT_FALSE(from_case<2>(motion_of(c, c.solid().body(0))).moves());
}

TEST(CarriedBody, WhatNothingHoldsOrMovesIsLeftAlone) {
  v1::Case c = rolling_tank<2>(Word::fem, 1e6);
  v1::Body& body = *c.mutable_solid()->mutable_body(0);
  v1::Case still = c;
  still.mutable_solid()->mutable_body(0)->mutable_motion();  // {}: stands still
  body.clear_clamp();
  for (const v1::Case& one : {c, still}) EXPECT_EQ(dynamic_cast<CarriedModel<2>*>(make(one).get()), nullptr);
}

}  // namespace
}  // namespace cosurge
