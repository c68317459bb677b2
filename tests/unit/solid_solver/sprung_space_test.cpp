// Rigid bodies that turn in space.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "common/vec.hpp"
#include "tests/support/loaded_solid.hpp"

namespace cosurge::sprung {
namespace {

using std::numbers::pi;
using test::LoadedSolid;

constexpr double density = 500;
const Vec<3> sides(0.1, 0.2, 0.04);
const Vec<3> centre = 0.5 * sides;
const double mass = density * sides.prod();

/// Moments of inertia of the brick about its centre [kg m2].
double inertia(int axis) { return mass / 12 * (sides.squaredNorm() - sides[axis] * sides[axis]); }

v1::Case brick(const std::vector<v1::Spring::Motion>& motions, const Vec<3>& gravity = Vec<3>::Zero()) {
  v1::Case c;
  c.set_dimension(3);
  for (const double g : gravity) c.add_gravity(g);
  v1::Solid& solid = *c.mutable_solid();
  solid.set_model(v1::SolidModel::sprung);
  solid.set_spacing(0.02);
  solid.set_density(density);
  test::set_box(*solid.add_body()->mutable_box(), {0, 0, 0}, {sides[0], sides[1], sides[2]});
  for (const auto motion : motions) solid.mutable_sprung()->add_spring()->set_motion(motion);
  return c;
}

const std::vector<v1::Spring::Motion> all_motions = {
    v1::Spring::x, v1::Spring::y, v1::Spring::z, v1::Spring::turn_x, v1::Spring::turn_y, v1::Spring::turn_z};
const std::vector<v1::Spring::Motion> turns = {v1::Spring::turn_x, v1::Spring::turn_y, v1::Spring::turn_z};

/// The centre and a point along each axis from it.
struct Brick : LoadedSolid {
  explicit Brick(const v1::Case& c) : LoadedSolid(c, points()) {}
  static Interface points() {
    Interface all{
        .dimension = 3, .position = centre.replicate(1, 4), .area = Field::Zero(3, 4), .body = {0, 0, 0, 0}};
    for (int k = 0; k < 3; ++k) all.position(k, 1 + k) += 0.5 * sides[k];
    return all;
  }
  /// The body's rotation matrix, from its points.
  Mat<3> rotation() const {
    const Field x = interface.position + motion.displacement;
    Mat<3> R;
    for (int k = 0; k < 3; ++k) R.col(k) = (x.col(1 + k) - x.col(0)) / (0.5 * sides[k]);
    return R;
  }
  double sum_of(const Report& report) const {
    return value(report, "kinetic_energy") + value(report, "elastic_energy") +
           value(report, "gravity_energy");
  }
  /// A moment about an axis of space for one window; the body must not have turned yet.
  Report kick(int axis, double moment, double window) {
    const int arm = (axis + 1) % 3, along = (axis + 2) % 3;
    load.force(along, 1 + arm) = moment / (0.5 * sides[arm]);
    load.force(along, 0) = -moment / (0.5 * sides[arm]);
    const Report report = advance(window);
    load.force.setZero();
    return report;
  }
};

TEST(SprungInSpace, ATopPrecessesAtTheRateOfItsAngularMomentum) {
  v1::Case c = brick(all_motions);
  // Equal sides along x and y: the axis z goes around the angular momentum at |L| / I_x.
  c.mutable_solid()->mutable_body(0)->mutable_box()->set_max(1, sides[0]);
  const double m = mass / 2, Ix = m / 12 * (0.1 * 0.1 + 0.04 * 0.04), Iz = m / 12 * 2 * 0.1 * 0.1;
  const Vec<3> L(0.3 * Ix, 0, 4 * Iz);  // 0.3 and 4 rad/s
  Interface points{
      .dimension = 3, .position = Field::Zero(3, 3), .area = Field::Zero(3, 3), .body = {0, 0, 0}};
  points.position << 0.05, 0.1, 0.05, 0.05, 0.05, 0.05, 0.02, 0.02, 0.04;
  LoadedSolid run(c, points);
  const double blow = 1e-6;                    // s: it does not turn in it
  run.load.force(1, 1) = L[2] / blow / 0.05;   // about z
  run.load.force(1, 2) = -L[0] / blow / 0.02;  // about x
  run.load.force.col(0) = -(run.load.force.col(1) + run.load.force.col(2));
  run.advance(blow);
  run.load.force.setZero();
  const double dt = 1e-3;
  double worst = 0, farthest = 0;
  for (int k = 1; k <= 1000; ++k) {
    run.advance(dt);
    const Field x = run.interface.position + run.motion.displacement;
    const Vec<3> axis = (x.col(2) - x.col(0)).normalized();
    const Vec<3> exact = Eigen::AngleAxisd(L.norm() / Ix * k * dt, L.normalized()) * Vec<3>(0, 0, 1);
    worst = std::max(worst, (axis - exact).norm());
    farthest = std::max(farthest, (axis - Vec<3>(0, 0, 1)).norm());
  }
  EXPECT_GT(farthest, 0.07);
  EXPECT_LT(worst, 1e-3 * farthest);  // second order: (omega dt)^2 / 12 of some 7 rad
}

TEST(SprungInSpace, ABrickThatTumblesKeepsEnergyAndAngularMomentum) {
  Brick run(brick(all_motions));
  // About the axis of middle inertia, x, which is unstable: it turns over.
  run.kick(0, 8 * inertia(0) / 1e-3, 1e-3);
  run.load.force(2, 1) = 1e-3;
  Report report = run.advance(1e-3);
  run.load.force.setZero();
  const double energy = run.sum_of(report);
  double turned_over = 1;
  for (int k = 0; k < 4000; ++k) {
    report = run.advance(1e-3);
    ASSERT_NEAR(run.sum_of(report) / energy, 1, 1e-11) << k;
    turned_over = std::min(turned_over, run.rotation()(0, 0));
  }
  EXPECT_LT(turned_over, -0.9);
  EXPECT_NEAR(run.value(report, "interface_work") / energy, 1, 1e-11);
  EXPECT_NEAR((run.rotation().transpose() * run.rotation() - Mat<3>::Identity()).norm(), 0, 1e-12);
}

TEST(SprungInSpace, LoadsAndSpringsDoTheWorkThatTheEnergiesTake) {
  v1::Case c = brick(all_motions, Vec<3>(0.3, -0.2, -9.81));
  for (int k = 0; k < 6; ++k) {
    v1::Spring& spring = *c.mutable_solid()->mutable_sprung()->mutable_spring(k);
    spring.set_stiffness(k < 3 ? 200 : 0.05 * (k - 2));
    spring.set_preload(k < 3 ? 0 : 0.01);
  }
  for (const auto path : {v1::Coupling::held, v1::Coupling::ramped}) {
    c.mutable_coupling()->set_load(path);
    Brick run(c);
    double most = 0, farthest = 0;
    for (int k = 0; k < 400; ++k) {
      for (int p = 0; p < 4; ++p)
        run.load.force.col(p) << 0.3 * std::sin(0.05 * k + p), 0.2 * std::cos(0.03 * k * p), 0.1 * p;
      const Report report = run.advance(2e-3);
      const double work = run.value(report, "interface_work");
      most = std::max(most, std::abs(run.value(report, "kinetic_energy")));
      farthest = std::max(farthest, (run.rotation() - Mat<3>::Identity()).norm());
      ASSERT_NEAR(run.sum_of(report), work, 1e-10 * most) << k;  // rounding, over the steps
    }
    EXPECT_GT(farthest, 0.3);
  }
}

TEST(SprungInSpace, SwingsOnItsSpringsAboutEachAxis) {
  const double omega = 2 * pi * 3;
  for (int axis = 0; axis < 3; ++axis) {
    v1::Case c = brick(turns);
    for (int k = 0; k < 3; ++k)
      c.mutable_solid()->mutable_sprung()->mutable_spring(k)->set_stiffness(inertia(k) * omega * omega *
                                                                            (1 + k));
    Brick run(c);
    const double dt = 1e-5, own = omega * std::sqrt(1. + axis);
    run.kick(axis, 0.05 * own * inertia(axis) / dt, dt);  // to 0.05 rad
    while (run.time < 0.25 * 2 * pi / own) run.advance(1e-4);
    const Mat<3> R = run.rotation();
    const int from = (axis + 1) % 3, to = (axis + 2) % 3;
    EXPECT_NEAR(std::atan2(R(to, from), R(from, from)), 0.05, 2e-5) << axis;
  }
}

TEST(SprungInSpace, ADamperTakesItsShareOfTheSpeed) {
  v1::Case c = brick(turns);
  const double rate = 2;  // 1/s
  for (int k = 0; k < 3; ++k)
    c.mutable_solid()->mutable_sprung()->mutable_spring(k)->set_damping(inertia(k) * rate);
  Brick run(c);
  const double before = run.value(run.kick(2, 0.5 * inertia(2) / 1e-4, 1e-4), "kinetic_energy");
  Report report;
  for (int k = 0; k < 500; ++k) report = run.advance(1e-3);
  EXPECT_NEAR(run.value(report, "kinetic_energy") / before, std::exp(-2 * rate * 0.5), 1e-4);
}

TEST(SprungInSpace, AboutOneAxisItIsTheBodyOfThePlane) {
  v1::Case space = brick({v1::Spring::turn_y}, Vec<3>(3, 0, -4)), plane = space;
  for (const double x : {0.01, 0.1, 0.0}) space.mutable_solid()->mutable_sprung()->add_pivot(x);
  plane.set_dimension(2);
  plane.clear_gravity();
  for (const double g : {3.0, -4.0}) plane.add_gravity(g);
  v1::Solid& solid = *plane.mutable_solid();
  solid.mutable_sprung()->mutable_spring(0)->set_motion(v1::Spring::turn);
  test::set_box(*solid.mutable_body(0)->mutable_box(), {0, 0}, {sides[0], sides[2]});
  for (const double x : {0.01, 0.0}) solid.mutable_sprung()->add_pivot(x);
  Brick run(space);
  LoadedSolid flat(
      plane,
      {.dimension = 2, .position = Vec<2>(centre[0], centre[2]), .area = Field::Zero(2, 1), .body = {0}});
  for (int k = 0; k < 700; ++k) {
    run.advance(1e-3);
    flat.advance(1e-3);
    ASSERT_NEAR(run.motion.displacement(0, 0), flat.motion.displacement(0, 0), 1e-10);
    ASSERT_NEAR(run.motion.displacement(2, 0), flat.motion.displacement(1, 0), 1e-10);
    ASSERT_EQ(run.motion.displacement(1, 0), 0);
  }
  EXPECT_GT(run.motion.displacement.norm(), 0.05);
}

TEST(SprungInSpace, SavedStateContinuesBitForBit) {
  Brick run(brick(all_motions)), other(brick(all_motions));
  run.kick(0, 1e-2, 1e-2);
  other.solid.restore(run.solid.save());
  for (Brick* one : {&run, &other})
    for (int k = 0; k < 5; ++k) one->advance(1e-3);
  EXPECT_EQ(run.motion.displacement, other.motion.displacement);
  EXPECT_EQ(run.motion.velocity, other.motion.velocity);
}

TEST(SprungInSpace, APivotBesideTheCentreOfABodyThatMovesIsRefused) {
  v1::Case beside = brick(all_motions);
  for (const double x : {0.0, 0.1, 0.02}) beside.mutable_solid()->mutable_sprung()->add_pivot(x);
  EXPECT_THROW(LoadedSolid(beside, {}), Error);
}

TEST(SprungInSpace, SpringsEndTheRunAtHalfATurn) {
  v1::Case wound = brick(turns);
  wound.mutable_solid()->mutable_sprung()->mutable_spring(0)->set_stiffness(1e-6);
  Brick run(wound);
  run.kick(0, 20 * inertia(0) / 1e-3, 1e-3);
  while (run.time < 0.15) run.advance(1e-3);
  EXPECT_THROW(while (run.time < 0.17) run.advance(1e-3), NumericalError);  // pi / 20 rad/s = 0.157 s
}

}  // namespace
}  // namespace cosurge::sprung
