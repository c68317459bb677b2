// Modes predict the response of the model, also for rotated bodies.
#include "solid_solver/point_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "common/case/from_case.hpp"
#include "common/geometry/motion.hpp"
#include "solid_solver/solid_participant.hpp"
#include "tests/support/outlines.hpp"
#include "tests/support/rolling_tank.hpp"

namespace cosurge {
namespace {

using Word = v1::SolidModel;

/// A participant whose body has points on all sites, with a scheme that asks for modes.
struct Asked {
  SolidParticipant solid;
  Interface interface;
  InterfaceMotion motion;
  InterfaceLoad load;
  std::uint64_t windows = 0;
  double time = 0;

  explicit Asked(v1::Case c) {
    c.mutable_coupling()->set_scheme(v1::Coupling::strong_inertial);
    c.mutable_coupling()->set_modes(12);
    c.mutable_solid()->mutable_modal()->set_modes(12);
    c.mutable_solid()->mutable_fem()->set_rho_infinity(1);  // with 0.3 it responds 9.5 % less to a new load
    interface = c.dimension() == 2 ? test::points_on<2>(c.solid().body(0), c.fluid().spacing())
                                   : test::points_on<3>(c.solid().body(0), c.fluid().spacing());
    load = InterfaceLoad::zero(c.dimension(), interface.points());
    static_cast<void>(solid.initialize(c, interface, load, motion));
  }
  void advance(double size, Attempt attempt = Attempt::once) {
    static_cast<void>(
        solid.advance({.index = windows, .start = time, .size = size, .attempt = attempt}, load, motion));
  }
  void go_on(double size) {
    advance(size);
    ++windows;
    time += size;
  }
  Field places() const { return interface.position + motion.displacement; }

  /// Error of the modes for another load in the next window, relative to the response.
  double missed(const Field& one, const Field& other, double size) {
    load.force = one;
    advance(size, Attempt::first);
    const Field first = motion.velocity;
    const std::vector<Mode> modes = motion.modes;
    load.force = other;
    advance(size, Attempt::again);
    const Field answer = motion.velocity - first;
    Field told = Field::Zero(answer.rows(), answer.cols());
    for (const Mode& mode : modes)
      told += mode.mobility * (mode.shape.cwiseProduct(other).sum() - mode.load) * mode.shape;
    EXPECT_FALSE(modes.empty());
    return (told - answer).norm() / answer.norm();
  }
};

class RollingModes : public testing::TestWithParam<std::tuple<Word::Word, int>> {};

TEST_P(RollingModes, TurnWithTheTank) {
  const auto [model, dimension] = GetParam();
  v1::Case c = dimension == 2 ? test::rolling_tank<2>(model, 1e6) : test::rolling_tank<3>(model, 1e6);
  c.mutable_fluid()->mutable_tank_motion()->set_angle(1);
  if (model == Word::sprung) c.mutable_solid()->mutable_sprung()->add_spring()->set_motion(v1::Spring::x);
  Asked run(c);
  Field none = Field::Zero(dimension, run.interface.points());
  // The load of the first mode: others respond with less than a hundredth of its response.
  const auto first_mode = [&] {
    run.load.force = none;
    run.advance(1e-3, Attempt::first);
    return run.motion.modes.at(0).shape;
  };
  const Field drawn = first_mode();
  while (run.time < 0.3) run.go_on(1e-3);
  const double angle = from_case<2>([&] {
                         v1::WallMotion plane = c.fluid().tank_motion();
                         plane.clear_pivot();
                         plane.clear_amplitude();
                         return plane;
                       }())
                           .turned(run.time + 5e-4)(1, 0);
  EXPECT_GT(angle, 0.7);  // its sine
  const Field now = first_mode();
  // Rotated from x to the last axis.
  const double sine = angle, cosine = std::sqrt(1 - sine * sine);
  Field expected = drawn;
  expected.row(0) = cosine * drawn.row(0) - sine * drawn.row(dimension - 1);
  expected.row(dimension - 1) = sine * drawn.row(0) + cosine * drawn.row(dimension - 1);
  EXPECT_LT((now - expected).norm(), 1e-6 * drawn.norm());  // the first window has turned by some 1e-8
  // The response is measured at the end of the window, the load acts half a window before: 1e-3 s of some
  // 5 rad/s.
  const double half_a_window = 5e-3;
  const double others = model == Word::modal || model == Word::sprung ? 0 : 0.15;  // modes after the 12th
  EXPECT_LT(run.missed(none, 10 * now, 1e-3), half_a_window + others);
}

INSTANTIATE_TEST_SUITE_P(Models, RollingModes,
                         testing::Values(std::tuple{Word::fem, 2}, std::tuple{Word::modal, 2},
                                         std::tuple{Word::sprung, 2}, std::tuple{Word::hamiltonian, 2},
                                         std::tuple{Word::modal, 3}, std::tuple{Word::sprung, 3}),
                         [](const auto& scene) {
                           return Word::Word_Name(std::get<0>(scene.param)) + "_" +
                                  std::to_string(std::get<1>(scene.param)) + "d";
                         });

class TurnedModes : public testing::TestWithParam<std::tuple<Word::Word, int>> {};

TEST_P(TurnedModes, TellTheSpinOfAFreeBodyThatHasTurned) {
  const auto [model, dimension] = GetParam();
  v1::Case c = dimension == 2 ? test::rolling_tank<2>(model, 1e7) : test::rolling_tank<3>(model, 1e7);
  c.mutable_fluid()->clear_tank_motion();
  c.set_gravity(dimension - 1, 0);
  v1::Body& body = *c.mutable_solid()->mutable_body(0);
  body.clear_clamp();
  body.mutable_box()->set_min(dimension - 1, 0.15);  // clear of the floor
  body.mutable_box()->set_max(dimension - 1, 0.27);
  if (model == Word::sprung)
    for (const auto motion : dimension == 2
                                 ? std::vector{v1::Spring::x, v1::Spring::y, v1::Spring::turn}
                                 : std::vector{v1::Spring::x, v1::Spring::y, v1::Spring::z,
                                               v1::Spring::turn_x, v1::Spring::turn_y, v1::Spring::turn_z})
      c.mutable_solid()->mutable_sprung()->add_spring()->set_motion(motion);
  Asked run(c);
  // A couple in the plane of x and the last axis, on the body as it stands.
  const auto couple = [&] {
    Field arm = run.places();
    arm.colwise() -= Eigen::VectorXd(arm.rowwise().mean());
    Field force = Field::Zero(dimension, arm.cols());
    force.row(0) = -arm.row(dimension - 1);
    force.row(dimension - 1) = arm.row(0);
    return force;
  };
  const double scale = 100 * 1500 * std::pow(0.01, dimension);  // 100 rad/s2
  // Points load elements at other places than inertia does, and higher modes respond, too, as in the initial
  // position.
  const double drawn = run.missed(0 * couple(), scale * couple(), 1e-3);
  while (run.windows < 400) {
    run.load.force =
        run.windows < 60 ? Field(scale * couple()) : Field(Field::Zero(dimension, couple().cols()));
    run.go_on(1e-3);
  }
  Field corner = run.interface.position.col(0) - run.interface.position.rowwise().mean();
  const Field placed = run.places().col(0) - run.places().rowwise().mean();
  const double cosine = (corner.col(0).dot(placed.col(0))) / (corner.norm() * placed.norm());
  EXPECT_LT(std::abs(cosine), 0.9);  // it has turned
  EXPECT_LT(run.missed(0 * couple(), scale * couple(), 1e-3), drawn + 0.01);
}

INSTANTIATE_TEST_SUITE_P(Models, TurnedModes,
                         testing::Values(std::tuple{Word::fem, 2}, std::tuple{Word::hamiltonian, 2},
                                         std::tuple{Word::mps, 2}, std::tuple{Word::sprung, 2},
                                         std::tuple{Word::sprung, 3}),
                         [](const auto& scene) {
                           return Word::Word_Name(std::get<0>(scene.param)) + "_" +
                                  std::to_string(std::get<1>(scene.param)) + "d";
                         });

}  // namespace
}  // namespace cosurge
