#include "fluid_solver/walls.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

#include "common/case/from_case.hpp"
#include "common/error.hpp"
#include "fluid_solver/gauges.hpp"
#include "fluid_solver/water_level.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using std::numbers::pi;

constexpr double l0 = 0.01;

v1::WallMotion formula() {
  v1::WallMotion motion;
  for (const double a : {0.02, 0.01}) motion.add_amplitude(a);
  for (const double x : {0.1, 0.0}) motion.add_pivot(x);
  motion.set_angle(0.3);
  motion.set_frequency(2);
  motion.set_phase(0.5);
  return motion;
}

v1::WallMotion table() {
  v1::WallMotion motion;
  for (int k = 0; k <= 20; ++k)
    for (const double value : {0.05 * k, std::sin(0.05 * k), 0.1, 0.0}) motion.add_row(value);
  return motion;
}

TEST(Motion, FollowsItsFormula) {
  const auto motion = from_case<2>(formula());
  const Vec<2> X(0.15, 0.2);
  EXPECT_LT((motion.place(X, 0) - X).norm(), 1e-15);
  const double t = 0.11;
  const double s = std::sin(2 * pi * 2 * t + 0.5) - std::sin(0.5);
  const double angle = 0.3 * s;
  const Vec<2> turned(0.1 + 0.05 * std::cos(angle) - 0.2 * std::sin(angle),
                      0.05 * std::sin(angle) + 0.2 * std::cos(angle));
  EXPECT_LT((motion.place(X, t) - turned - s * Vec<2>(0.02, 0.01)).norm(), 1e-15);
}

TEST(Motion, ARampStartsItWithoutAJump) {
  v1::WallMotion ramped = formula();
  ramped.set_ramp(0.2);
  const auto motion = from_case<2>(ramped);
  const Vec<2> X(0.15, 0.2);
  constexpr double dt = 1e-6;
  EXPECT_LT((motion.place(X, dt) - X).norm() / dt, 1e-4);  // the speed is about 0.4 m/s
  EXPECT_GT((motion.place(X, 0.2 + dt) - motion.place(X, 0.2)).norm() / dt, 0.01);
}

TEST(Motion, ATableIsMetAtItsRowsAndBetweenThemToThirdOrder) {
  const auto motion = from_case<2>(table());
  for (const double t : {0.0, 0.05, 0.5, 1.0}) EXPECT_NEAR(motion.place({0, 0}, t)[0], std::sin(t), 1e-14);
  // Cubic with slopes from differences, rows 0.05 s apart: h^3 / 6 in a slope, h / 4 of it in between.
  EXPECT_NEAR(motion.place({0, 0}, 0.525)[0], std::sin(0.525), 1e-5);
  EXPECT_EQ(motion.place({0, 0}, 7)[0], motion.place({0, 0}, 1)[0]);  // then it stands
  EXPECT_EQ(motion.place({0, 0}, 0.5)[1], 0);                         // the rows count from the first
}

/// A table with one coordinate.
v1::WallMotion table_of_x(const std::vector<std::pair<double, double>>& rows) {
  v1::WallMotion motion;
  for (const auto& [t, x] : rows)
    for (const double value : {t, x, 0.0, 0.0}) motion.add_row(value);
  return motion;
}

double x_at(const v1::WallMotion& motion, double t) { return from_case<2>(motion).place({0, 0}, t)[0]; }

TEST(Motion, RestsOfATableStayAtRestAndNothingOvershoots) {
  const v1::WallMotion stroke = table_of_x({{0, 0}, {1, 0}, {1.1, 0.1}, {2, 0.1}});
  for (int k = 0; k <= 300; ++k) {
    const double t = 0.01 * k, x = x_at(stroke, t);
    if (t <= 1) {
      EXPECT_EQ(x, 0) << t;
    }
    if (t >= 1.1) {
      EXPECT_NEAR(x, 0.1, 1e-15) << t;
    }
    EXPECT_GE(x, 0);
    EXPECT_LE(x, 0.1);
  }
  EXPECT_NEAR(x_at(stroke, 1.05), 0.05, 1e-15);  // by symmetry
}

TEST(Motion, BetweenTwoRowsATableNeverLeavesTheirRange) {
  const std::vector<std::vector<double>> ways = {{0, 0, 1, 1, 0, 0},
                                                 {0, 1, 0, -1, 0, 1},
                                                 {0, 1e-6, 1, 1 + 1e-6, 2},
                                                 {0, 1, 1.001, 1.002, 5},
                                                 {5, 1.002, 1.001, 1, 0, 0},
                                                 {0, 10, 10.5, 10.5, 10},
                                                 {1, -1},
                                                 {0, 0, 0, 3, 3, -2, -2, -2.5}};
  for (const double uneven : {0.0, 0.4, 0.95}) {
    for (const std::vector<double>& way : ways) {
      std::vector<std::pair<double, double>> rows;
      for (std::size_t k = 0; k < way.size(); ++k)
        rows.emplace_back(static_cast<double>(k) + (k % 2 == 0 ? 0 : uneven), way[k]);
      const v1::WallMotion motion = table_of_x(rows);
      for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
        double before = x_at(motion, rows[k].first);
        for (int part = 1; part <= 50; ++part) {
          const double t = rows[k].first + 0.02 * part * (rows[k + 1].first - rows[k].first);
          const double x = x_at(motion, t);
          // Monotone, to rounding.
          EXPECT_GE((x - before) * (way[k + 1] - way[k] >= 0 ? 1 : -1), -1e-14) << k << " " << t;
          before = x;
        }
        EXPECT_NEAR(before, way[k + 1] - way[0], 1e-14);
      }
    }
  }
}

TEST(Motion, ATableOfConstantSpeedHasIt) {
  const v1::WallMotion motion = table_of_x({{0, 0}, {0.3, 0.15}, {1, 0.5}});
  for (double t = 0; t <= 1; t += 0.07) EXPECT_NEAR(x_at(motion, t), 0.5 * t, 1e-15);
}

TEST(Motion, StandsBeforeItsTableBeginsAndAfterItEnds) {
  const v1::WallMotion late = table_of_x({{1, 0.2}, {2, 0.5}});
  for (const double t : {0.0, 0.5, 1.0}) EXPECT_EQ(x_at(late, t), 0);
  EXPECT_NEAR(x_at(late, 1.5), 0.15, 1e-15);
  for (const double t : {2.0, 9.0}) EXPECT_NEAR(x_at(late, t), 0.3, 1e-15);
}

TEST(Motion, OfATableThatBeganEarlierCountsFromTheStartOfTheRun) {
  const v1::WallMotion early = table_of_x({{-1, 0}, {1, 0.4}});
  EXPECT_EQ(x_at(early, 0), 0);
  EXPECT_NEAR(x_at(early, 0.5), 0.1, 1e-15);
  EXPECT_NEAR(x_at(early, 3), 0.2, 1e-15);
  const v1::WallMotion over = table_of_x({{-2, 0}, {-1, 0.4}});
  for (const double t : {0.0, 1.0}) EXPECT_EQ(x_at(over, t), 0);
}

TEST(Motion, OriginUndoesPlace) {
  for (const v1::WallMotion& m : {formula(), table()}) {
    const auto motion = from_case<2>(m);
    const Vec<2> X(0.15, 0.2);
    EXPECT_LT((motion.origin(motion.place(X, 0.33), 0.33) - X).norm(), 1e-15);
  }
}

TEST(Motion, TheSweepHoldsEveryPlace) {
  const auto motion = from_case<2>(formula());
  const Box<2> swept = motion.sweep({{0, 0}, {0.3, 0.3}});
  const Vec<2> rounding = Vec<2>::Constant(1e-3);  // samples: 64 a period
  for (double t = 0; t < 1; t += 0.01)
    EXPECT_TRUE((Box<2>(swept.min - rounding, swept.max + rounding).contains(motion.place({0.3, 0.3}, t))));
}

/// A tank with an obstacle of 6 x 5 sites on its floor.
v1::Fluid tank_with_obstacle(const v1::WallMotion* motion = nullptr) {
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.3, 0.3}), {test::box_of({0, 0}, {0.2, 0.1})});
  v1::Obstacle& obstacle = *fluid.add_obstacle();
  for (const double x : {0.1, 0.0}) obstacle.mutable_shape()->add_min(x);
  for (const double x : {0.16, 0.05}) obstacle.mutable_shape()->add_max(x);
  if (motion != nullptr) *obstacle.mutable_motion() = *motion;
  return fluid;
}

TEST(Walls, TheOutermostLayerOfAnObstacleHasPressureAndItsInnerSitesAreDummies) {
  const Walls<2> walls(water_from_case<2>(tank_with_obstacle(), Vec<2>::Zero()), 3);
  Particles<2> particles;
  Walls<2>(water_from_case<2>(tank_with_obstacle(), Vec<2>::Zero()), 3).add_to(particles);
  std::map<Kind, int> inside;
  for (int i = 0; i < particles.size(); ++i)
    if (walls.covers(particles.x[i])) ++inside[particles.kind[i]];
  EXPECT_EQ(inside[Kind::wall], 6 * 5 - 4 * 3);
  EXPECT_EQ(inside[Kind::dummy], 4 * 3);
}

TEST(Walls, WaterGivesWayToAnObstacle) {
  const auto mps = test::mps_of<2>(tank_with_obstacle(), nullptr, {0, -9.81});
  int water = 0;
  for (int i = 0; i < mps.particles().size(); ++i) water += mps.particles().kind[i] == Kind::fluid ? 1 : 0;
  EXPECT_EQ(water, 20 * 10 - 6 * 5);
}

/// The tank with obstacles between these corners.
v1::Fluid tank_with_obstacles(const std::vector<std::array<double, 4>>& boxes) {
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.3, 0.3}), {test::box_of({0, 0}, {0.1, 0.1})});
  for (const auto& [x0, y0, x1, y1] : boxes) {
    v1::Shape& shape = *fluid.add_obstacle()->mutable_shape();
    for (const double x : {x0, y0}) shape.add_min(x);
    for (const double x : {x1, y1}) shape.add_max(x);
  }
  return fluid;
}

/// Walls and dummies, no two of them in one place.
int distinct_sites(const v1::Fluid& fluid) {
  Particles<2> particles;
  Walls<2>(water_from_case<2>(fluid, Vec<2>::Zero()), 3).add_to(particles);
  std::map<std::pair<long, long>, int> sites;
  for (const Vec<2>& x : particles.x) ++sites[{std::lround(x[0] / l0 * 2), std::lround(x[1] / l0 * 2)}];
  EXPECT_EQ(sites.size(), particles.x.size());
  return static_cast<int>(sites.size());
}

TEST(Walls, OfOnePlaceCountOnce) {
  const int tank = distinct_sites(tank_with_obstacles({}));
  EXPECT_EQ(tank, 38 * 34 - 30 * 30);
  struct Overlap {
    std::vector<std::array<double, 4>> boxes;
    int more;  // sites than the tank's own
  };
  const std::vector<Overlap> overlaps = {
      {{{0.1, 0, 0.2, 0.05}}, 10 * 5},                               // on the floor
      {{{0.1, -0.04, 0.2, 0.05}}, 10 * 5},                           // as deep as the floor
      {{{0.1, -0.02, 0.2, 0.05}}, 10 * 5},                           // less deep
      {{{0.1, -0.3, 0.2, 0.05}}, 10 * 5},                            // deeper
      {{{-0.04, -0.04, 0.05, 0.05}}, 5 * 5},                         // in a corner
      {{{-0.3, -0.3, 0.6, 0.05}}, 30 * 5},                           // a whole bottom
      {{{0.1, 0.2, 0.2, 0.4}}, 10 * 20},                             // out of the top
      {{{0.28, 0.2, 0.34, 0.4}}, 2 * 20 + 4 * 10},                   // onto the rim of a side wall
      {{{0.1, 0, 0.2, 0.05}, {0.15, 0, 0.25, 0.1}}, 50 + 100 - 25},  // each other
      {{{0.1, 0, 0.2, 0.05}, {0.1, 0, 0.2, 0.05}}, 50},              // the same twice
  };
  for (std::size_t k = 0; k < overlaps.size(); ++k)
    EXPECT_EQ(distinct_sites(tank_with_obstacles(overlaps[k].boxes)) - tank, overlaps[k].more) << k;
}

TEST(Walls, OfOnePlaceCountOnceInSpaceToo) {
  v1::Fluid fluid;
  fluid.set_spacing(0.1);
  for (const double x : {0.0, 0.0, 0.0}) fluid.mutable_tank()->add_min(x);
  for (const double x : {1.0, 1.0, 1.0}) fluid.mutable_tank()->add_max(x);
  const auto sites = [&] {
    Particles<3> particles;
    Walls<3>(water_from_case<3>(fluid, Vec<3>::Zero()), 3).add_to(particles);
    std::set<std::array<long, 3>> places;
    for (const Vec<3>& x : particles.x)
      places.insert({std::lround(20 * x[0]), std::lround(20 * x[1]), std::lround(20 * x[2])});
    EXPECT_EQ(places.size(), particles.x.size());
    return static_cast<int>(places.size());
  };
  const int tank = sites();
  EXPECT_EQ(tank, 18 * 18 * 14 - 10 * 10 * 10);
  v1::Shape& shape = *fluid.add_obstacle()->mutable_shape();
  for (const double x : {-0.4, 0.2, -0.4}) shape.add_min(x);
  for (const double x : {0.5, 1.4, 0.4}) shape.add_max(x);
  EXPECT_EQ(sites(), tank + 5 * 8 * 4);
}

TEST(Walls, WhatOfAMovingObstacleLiesInTheFloorStaysThere) {
  v1::Fluid fluid = tank_with_obstacles({{0.1, -0.04, 0.2, 0.05}});
  *fluid.mutable_obstacle(0)->mutable_motion() = table_of_x({{0, 0}, {1, 0.05}});
  Walls<2> walls(water_from_case<2>(fluid, Vec<2>::Zero()), 3);
  Particles<2> particles;
  walls.add_to(particles);
  const std::vector<Vec<2>> before = particles.x;
  walls.move(particles, 1, 0.01);
  int moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i) moved += particles.x[i] != before[i] ? 1 : 0;
  EXPECT_EQ(moved, 10 * 5);
}

TEST(Walls, AnObstacleThatMovesIntoAnotherWallIsNamed) {
  struct Way {
    double x, y;       // way of the first obstacle in a second
    std::string into;  // nothing: it has room
  };
  const std::vector<Way> ways = {
      {0.05, 0.05, ""},
      {-0.1, 0, ""},  // it touches the wall
      {-0.12, 0, "fluid.obstacle.0 has moved into a side wall of the tank"},
      {0, -0.03, "fluid.obstacle.0 has moved into the tank's floor"},
      {0.05, 0, ""},  // it touches the other obstacle
      {0.08, 0, "fluid.obstacle.1 and fluid.obstacle.0 have moved into each other"},
      {0, 0.4, ""}};  // out of the top
  for (const Way& way : ways) {
    v1::Fluid fluid = tank_with_obstacles({{0.1, 0, 0.15, 0.1}, {0.2, 0, 0.25, 0.1}});
    for (const double value : {0.0, 0.0, 0.0, 0.0, 1.0, way.x, way.y, 0.0})
      fluid.mutable_obstacle(0)->mutable_motion()->add_row(value);
    const Walls<2> walls(water_from_case<2>(fluid, Vec<2>::Zero()), 3);
    std::string said;
    try {
      walls.require_room(1);
    } catch (const NumericalError& error) {
      said = error.what();
    }
    EXPECT_EQ(said.empty(), way.into.empty()) << said;
    EXPECT_TRUE(said.starts_with(way.into)) << said;
  }
}

TEST(Walls, WaterRestsBesideAnObstacleInTheFloor) {
  const v1::Fluid fluid = tank_with_obstacles({{0.1, -0.3, 0.16, 0.2}, {0.12, -0.04, 0.3, 0.1}});
  auto mps = test::mps_of<2>(fluid, nullptr, {0, -9.81});
  for (int step = 0; step < 20; ++step) EXPECT_NO_THROW(mps.step(1e-3 * step, 1e-3, Attempt::first));
}

TEST(Walls, MoveAsTheyAreToldWithTheirMeanVelocity) {
  const v1::WallMotion motion = formula();
  Walls<2> walls(water_from_case<2>(tank_with_obstacle(&motion), Vec<2>::Zero()), 3);
  Particles<2> particles;
  walls.add_to(particles);
  const Particles<2> rest = particles;
  constexpr double dt = 0.01;
  walls.move(particles, 0.2, dt);
  double fastest = 0;
  const auto path = from_case<2>(motion);
  for (int i = 0; i < particles.size(); ++i) {
    const bool obstacle = walls.covers(rest.x[i]);
    const Vec<2> there = obstacle ? path.place(rest.x[i], 0.2) : rest.x[i];
    EXPECT_LT((particles.x[i] - there).norm(), 1e-15);
    const Vec<2> before = obstacle ? path.place(rest.x[i], 0.2 - dt) : rest.x[i];
    EXPECT_LT((particles.u[i] - (there - before) / dt).norm(), 1e-13);
    fastest = std::max(fastest, particles.u[i].norm());
  }
  EXPECT_EQ(walls.speed(), fastest);
  EXPECT_GT(fastest, 0.01);
}

TEST(Walls, AMovingTankTakesItsBoundsAlong) {
  v1::Fluid fluid = tank_with_obstacle();
  *fluid.mutable_tank_motion() = table();
  const Walls<2> walls(water_from_case<2>(fluid, Vec<2>::Zero()), 3);
  EXPECT_FALSE(walls.outside({0.9, 0.1}, 0.8));  // the tank has gone 0.717 m
  EXPECT_TRUE(walls.outside({0.1, 0.1}, 0.8));
  EXPECT_TRUE(walls.outside({0.9, 0.1}, 0));
  EXPECT_TRUE(walls.domain().contains({1.1, 0.1}));
}

/// x(t) of a tank whose acceleration grows to `a` within a second and stays so.
v1::WallMotion acceleration(double a, double end) {
  v1::WallMotion motion;
  for (double t = 0; t < end + 0.01; t += 0.01) {
    const double x = t < 1 ? a / 2 * (t * t / 2 - (1 - std::cos(pi * t)) / (pi * pi))
                           : a / 2 * (0.5 - 2 / (pi * pi)) + a / 2 * (t - 1) + a / 2 * (t - 1) * (t - 1);
    for (const double value : {t, x, 0.0, 0.0}) motion.add_row(value);
  }
  return motion;
}

// Accelerated evenly, water leans by a / g: its surface is normal to g - a.
TEST(Walls, WaterInAnAcceleratedTankLeansAsMuchAsItMust) {
  constexpr double length = 0.2, a = 2, g = 9.81, end = 1.6;
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {length, 0.3}), {test::box_of({0, 0}, {length, 0.1})});
  fluid.set_source(v1::Fluid::mixed);
  fluid.set_gradient(v1::Fluid::conserving);
  *fluid.mutable_tank_motion() = acceleration(a, end);
  const auto tank = from_case<2>(fluid.tank_motion());
  auto mps = test::mps_of<2>(fluid, nullptr, {0, -g});
  constexpr double dt = 1e-3;
  double difference = 0;
  int count = 0;
  for (int k = 0; (k + 1) * dt < end; ++k) {
    (void)mps.step(k * dt, dt);
    const double t = (k + 1) * dt;
    if (t < 1.05) continue;  // one period of sloshing, 0.53 s, is averaged over
    const WaterParts parts = connected_water(mps, l0);
    const auto level = [&](double x) {
      return level_over<2>(mps, parts, {.foot = tank.place({x, 0}, t), .up = {0, 1}}, l0);
    };
    difference += level(0.01) - level(length - 0.01);
    ++count;
  }
  EXPECT_EQ(mps.particles().size(), mps.initial_size());
  EXPECT_NEAR(difference / count, (length - 0.02) * a / g, 0.5 * l0);  // to half a spacing
}

/// Where the particle nearest to X at the start is at time t.
Vec<2> carried(const v1::Fluid& fluid, const Vec<2>& X, double t) {
  Walls<2> walls(water_from_case<2>(fluid, Vec<2>::Zero()), 3);
  Particles<2> particles;
  walls.add_to(particles);
  int nearest = 0;
  for (int i = 0; i < particles.size(); ++i)
    if ((particles.x[i] - X).norm() < (particles.x[nearest] - X).norm()) nearest = i;
  walls.move(particles, t, 1e-3);
  walls.require_room(t);
  return particles.x[nearest];
}

TEST(Walls, ObstaclesMoveWithTheTankUnlessTheySayOtherwise) {
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.6, 0.4}), {test::box_of({0, 0}, {0.1, 0.1})});
  v1::WallMotion& tank = *fluid.mutable_tank_motion();
  tank.add_amplitude(0.05);
  tank.add_amplitude(0);
  tank.set_angle(0.2);
  tank.set_frequency(1);
  v1::Obstacle& obstacle = *fluid.add_obstacle();
  *obstacle.mutable_shape() = shape_of(test::box_of({0.3, 0}, {0.4, 0.2}));  // it stands on the floor
  const Vec<2> X(0.305, 0.105);
  const Vec<2> with_tank = carried(fluid, X, 0.2);
  EXPECT_LT((with_tank - from_case<2>(tank).place(X, 0.2)).norm(), 1e-14);
  EXPECT_GT((with_tank - X).norm(), 0.02);
  // Above the floor, which moves.
  *obstacle.mutable_shape() = shape_of(test::box_of({0.3, 0.15}, {0.4, 0.25}));
  obstacle.mutable_motion();
  EXPECT_LT((carried(fluid, {0.305, 0.205}, 0.2) - Vec<2>(0.305, 0.205)).norm(), 1e-14);
}

}  // namespace
}  // namespace cosurge::fluid
