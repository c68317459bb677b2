#include "fluid_solver/covered_walls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "common/case/from_case.hpp"
#include "fluid_solver/bodies.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;

/// A tank of 10 x 10 cells with a body in it that is moved by `shift` and has the velocity (1, 2) m/s.
struct Scene {
  v1::Fluid fluid;
  std::unique_ptr<Walls<2>> walls;
  Particles<2> particles;
  std::unique_ptr<Neighbors<2>> neighbors;
  std::vector<Cover> covers;

  explicit Scene(const v1::Box& box, const Vec<2>& shift = Vec<2>::Zero()) {
    fluid.set_spacing(l0);
    *fluid.mutable_tank() = test::box_of({0, 0}, {0.1, 0.1});
    walls = std::make_unique<Walls<2>>(water_from_case<2>(fluid, Vec<2>::Zero()), 3);
    walls->add_to(particles);
    const auto bodies = test::bodies_of<2>(test::solid_of(box), from_case<2>(fluid.tank()), l0);
    for (int k = 0; k < bodies.points(); ++k) {
      particles.add(bodies.wet(k) ? Kind::body_surface : Kind::body_inner, bodies.position(k) + shift);
      particles.u.back() = {1, 2};
    }
    neighbors = std::make_unique<Neighbors<2>>(walls->domain(), 2.1 * l0);
    search();
  }

  void search() {
    neighbors->rebuild(particles);
    covers = cover_walls(particles, *neighbors, *walls, l0);
    follow_covers(particles, covers);
  }

  /// Kind of the first wall layer by the lattice index of its cells.
  std::map<std::pair<int, int>, Kind> kinds() const {
    std::map<std::pair<int, int>, Kind> kinds;
    for (int i = 0; i < particles.size(); ++i) {
      const Vec<2> cell = (particles.x[i] / l0).array().floor();
      const bool first = cell.minCoeff() >= -1 && cell[0] <= 10 && (cell.minCoeff() < 0 || cell[0] > 9);
      if (first) kinds[{static_cast<int>(cell[0]), static_cast<int>(cell[1])}] = particles.kind[i];
    }
    return kinds;
  }
};

TEST(CoverWalls, APistonFromWallToWallLeavesNoWallBesideItButAtItsTop) {
  Scene scene(test::box_of({0, 0}, {0.1, 0.04}));
  const auto kinds = scene.kinds();
  for (int j = 0; j < 10; ++j)
    for (const int side : {-1, 10})
      EXPECT_EQ(kinds.at({side, j}), j >= 3 ? Kind::wall : Kind::dummy) << side << " " << j;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(kinds.at({i, -1}), Kind::dummy) << i;
}

TEST(CoverWalls, WhatIsCoveredMovesWithWhatCoversIt) {
  Scene scene(test::box_of({0, 0}, {0.1, 0.04}));
  EXPECT_EQ(scene.covers.size(), 10u + 2 * 4);
  for (const Cover& cover : scene.covers) {
    EXPECT_EQ(scene.particles.u[cover.wall], Vec<2>(1, 2));
    EXPECT_EQ(scene.particles.normal[cover.wall], scene.particles.normal[cover.by]);
  }
}

TEST(CoverWalls, AWallIsAWallAgainWhenTheBodyHasLeftIt) {
  Scene scene(test::box_of({0.02, 0}, {0.07, 0.08}));
  const auto before = scene.kinds();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(before.at({i, -1}), i < 3 || i > 5 ? Kind::wall : Kind::dummy) << i;
  for (int j = 0; j < 10; ++j)
    EXPECT_TRUE(before.at({-1, j}) == Kind::wall && before.at({10, j}) == Kind::wall);
  for (int i = 0; i < scene.particles.size(); ++i)
    if (of_body(scene.particles.kind[i])) scene.particles.x[i][1] += 0.2 * l0;
  scene.walls->move(scene.particles, 1e-3, 1e-3);
  scene.search();
  EXPECT_TRUE(scene.covers.empty());
  for (int i = 0; i < 10; ++i) EXPECT_EQ(scene.kinds().at({i, -1}), Kind::wall) << i;
  for (int i = 0; i < scene.particles.size(); ++i) {
    if (scene.particles.kind[i] != Kind::wall) continue;
    EXPECT_EQ(scene.particles.u[i], Vec<2>(0, 0));
    EXPECT_FALSE(scene.particles.normal[i].isZero());
  }
}

TEST(CoverWalls, ABodyInTheOpenCoversNothing) {
  const Scene open(test::box_of({0.04, 0.04}, {0.06, 0.06}));
  EXPECT_TRUE(open.covers.empty());
  int walls = 0;
  for (const Kind kind : open.particles.kind) walls += kind == Kind::wall ? 1 : 0;
  EXPECT_EQ(walls, 10 + 2 * 11);
  EXPECT_TRUE(Scene(test::box_of({0.02, 0}, {0.07, 0.08}), {0, 0.2 * l0}).covers.empty());
}

TEST(CoverWalls, AMovingObstacleCoversTheTankAndNotTheTankTheObstacle) {
  for (const double amplitude : {0.0, 0.01}) {
    v1::Fluid fluid;
    fluid.set_spacing(l0);
    *fluid.mutable_tank() = test::box_of({0, 0}, {0.1, 0.1});
    v1::Obstacle* piston = fluid.add_obstacle();
    *piston->mutable_shape() = shape_of(test::box_of({0.03, 0}, {0.06, 0.08}));
    if (amplitude > 0) {
      for (const double a : {amplitude, 0.0}) piston->mutable_motion()->add_amplitude(a);
      piston->mutable_motion()->set_frequency(1);
    }
    Walls<2> walls(water_from_case<2>(fluid, Vec<2>::Zero()), 3);
    Particles<2> particles;
    walls.add_to(particles);
    Neighbors<2> neighbors(walls.domain(), 2.1 * l0);
    neighbors.rebuild(particles);
    const auto covers = cover_walls(particles, neighbors, walls, l0);
    EXPECT_EQ(covers.size(), amplitude > 0 ? 3u : 0u);
    for (const Cover& cover : covers) {
      EXPECT_LT(particles.x[cover.wall][1], 0);
      EXPECT_EQ(particles.kind[cover.wall], Kind::dummy);
    }
  }
}

}  // namespace
}  // namespace cosurge::fluid
