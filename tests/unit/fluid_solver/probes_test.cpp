// Probes that move with the object they are fixed to.
#include "fluid_solver/probes.hpp"

#include <gtest/gtest.h>

#include "fluid_solver/body_load.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;
constexpr double rho_g = 9810;

v1::Probe probe(const std::string& name, v1::Probe::Quantity quantity, const std::vector<double>& position) {
  v1::Probe probe;
  probe.set_name(name);
  probe.set_quantity(quantity);
  probe.mutable_position()->Assign(position.begin(), position.end());
  return probe;
}

/// A case with water 0.1 m deep in a tank of 0.3 m.
v1::Case still_water() {
  v1::Case c;
  c.set_dimension(2);
  for (const double g : {0.0, -9.81}) c.add_gravity(g);
  *c.mutable_fluid() =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.3, 0.3}), {test::box_of({0, 0}, {0.3, 0.1})});
  return c;
}

/// (t, x, y, angle) from rest to `way` within 0.2 s.
v1::WallMotion ride(const Vec<2>& way, double angle) {
  v1::WallMotion motion;
  for (const double value : {0.0, 0.0, 0.0, 0.0, 0.2, way[0], way[1], angle}) motion.add_row(value);
  return motion;
}

std::vector<double> read_after(const v1::Case& c, double end) {
  auto mps = test::mps_of<2>(c.fluid(), nullptr, {0, -9.81});
  const Interface interface = mps.bodies().interface();
  Probes<2> probes(probes_from_case<2>(c), mps, interface);
  constexpr double dt = 1e-3;
  double t = 0;
  while (t < end - 0.5 * dt) {
    (void)mps.step(t, dt);
    t += dt;
  }
  return probes.read({.motion = InterfaceMotion::at_rest(2, 0), .load = InterfaceLoad::zero(2, 0), .end = t});
}

TEST(Probes, OfPressureRideOnAMovingObstacle) {
  v1::Case c = still_water();
  v1::Obstacle& obstacle = *c.mutable_fluid()->add_obstacle();
  *obstacle.mutable_shape() = shape_of(test::box_of({0.1, 0.06}, {0.2, 0.12}));
  *obstacle.mutable_motion() = ride({0, -0.01}, 0);
  *c.mutable_output()->add_probe() = probe("below", v1::Probe::pressure, {0.15, 0.06});
  *c.mutable_output()->add_probe() = probe("fixed", v1::Probe::pressure, {0.05, 0.06});
  const auto values = read_after(c, 0.5);
  // The obstacle displaces 0.05 x 0.1 m more than at the start, whose 0.04 x 0.1 m were no water: the level
  // rises by 0.01 x 0.1 / 0.2.
  const double level = 0.1 + 0.01 * 0.1 / 0.2;
  EXPECT_NEAR(values[0], rho_g * (level - 0.05), 0.04 * rho_g * 0.05);
  EXPECT_NEAR(values[1], rho_g * (level - 0.06), 0.04 * rho_g * 0.05);
}

TEST(Probes, OfATankThatMovesGoWithIt) {
  v1::Case c = still_water();
  *c.mutable_fluid()->mutable_tank_motion() = ride({0.03, 0.02}, 0);
  *c.mutable_output()->add_probe() = probe("wall", v1::Probe::pressure, {0.3, 0.02});
  *c.mutable_output()->add_probe() = probe("gauge", v1::Probe::level, {0.15, 0.05});
  const auto values = read_after(c, 0.2);
  v1::Case at_rest = c;
  at_rest.mutable_fluid()->clear_tank_motion();
  // The right wall is now at x = 0.33, and the floor at y = 0.02: a fixed gauge would be in the water, or
  // lower by 0.02.
  EXPECT_GT(values[0], 0.4 * rho_g * 0.08);
  EXPECT_NEAR(values[1], read_after(at_rest, 0.2)[1], 0.01);
}

TEST(Probes, OfLevelsGoUpAlongTheTank) {
  // A tank that has turned by 0.1 rad sees the level of its middle along its own axis: over the foot, which
  // turns about the origin, by the depth there over the cosine.
  const auto mps = test::mps_of<2>(still_water().fluid(), nullptr, {0, -9.81});
  const WaterParts parts = connected_water(mps, l0);
  const double upright = level_over<2>(mps, parts, {.foot = {0.15, 0}, .up = {0, 1}}, l0);
  for (const double angle : {-0.3, 0.3}) {
    const GaugeLine<2> leaning{.foot = {0.15, 0}, .up = {-std::sin(angle), std::cos(angle)}};
    EXPECT_NEAR(level_over(mps, parts, leaning, l0), upright / std::cos(angle), 0.1 * l0) << angle;
  }
}

TEST(Probes, HaveColumnsOfForceAndMoment) {
  v1::Case c = still_water();
  *c.mutable_output()->add_probe() = probe("thrust", v1::Probe::force, {0.3, 0.05});
  *c.mutable_output()->add_probe() = probe("hinge", v1::Probe::moment, {0.3, 0.05});
  const auto mps = test::mps_of<2>(c.fluid(), nullptr, {0, -9.81});
  const Interface interface = mps.bodies().interface();
  const Probes<2> probes(probes_from_case<2>(c), mps, interface);
  std::vector<std::string> names, units;
  for (const Column& column : probes.columns()) names.push_back(column.name), units.push_back(column.unit);
  EXPECT_EQ(names, (std::vector<std::string>{"thrust_x", "thrust_y", "hinge"}));
  EXPECT_EQ(units, (std::vector<std::string>{"N", "N", "N m"}));
}

TEST(BodyLoad, TakesTheMomentAboutAPointThatMovesWithTheBody) {
  Interface interface;
  interface.position.resize(2, 2);
  interface.position << 0.005, 0.015, 0.005, 0.005;
  interface.body = {0, 0};
  InterfaceMotion motion = InterfaceMotion::at_rest(2, 2);
  InterfaceLoad load = InterfaceLoad::zero(2, 2);
  load.force << 0, 0, 1, 3;  // 1 N and 3 N upwards
  motion.displacement << 0.5, 0.5, 0.25, 0.25;
  const Load<2> sum = BodyLoad<2>(interface, 0, {0.01, 0.005}, 0.01).read(motion, load);
  EXPECT_EQ(sum.force, Vec<2>(0, 4));
  EXPECT_NEAR(sum.moment[2], -0.005 * 1 + 0.005 * 3, 1e-15);
}

}  // namespace
}  // namespace cosurge::fluid
