#include "fluid_solver/buried_walls.hpp"

#include <gtest/gtest.h>

#include <set>

#include "fluid_solver/walls.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;

/// Walls of a tank of 10 x 10 cells with a body in it, by the lattice index of their cells.
std::set<std::pair<int, int>> walls_beside(const v1::Box& box) {
  const Box<2> tank({0, 0}, {0.1, 0.1});
  Particles<2> particles;
  v1::Fluid fluid;
  fluid.set_spacing(l0);
  *fluid.mutable_tank() = test::box_of({0, 0}, {0.1, 0.1});
  Walls<2>(fluid, 3).add_to(particles);
  v1::Body body;
  *body.mutable_box() = box;
  bury_walls(particles, tank, {BodySites<2>(body, l0)}, 2.1 * l0, l0);
  std::set<std::pair<int, int>> walls;
  for (int i = 0; i < particles.size(); ++i)
    if (particles.kind[i] == Kind::wall)
      walls.emplace(static_cast<int>(std::floor(particles.x[i][0] / l0)),
                    static_cast<int>(std::floor(particles.x[i][1] / l0)));
  return walls;
}

TEST(BuryWalls, APistonFromWallToWallLeavesNoWallUnderIt) {
  const auto walls = walls_beside(test::box_of({0, 0}, {0.1, 0.04}));
  // Water at 2.1 spacings or less: two beside and one up, not two up. The row beside the piston's top stays.
  for (int j = -1; j < 10; ++j) {
    EXPECT_EQ(walls.contains({-1, j}), j >= 3) << j;
    EXPECT_EQ(walls.contains({10, j}), j >= 3) << j;
  }
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(walls.contains({i, -1}));
}

TEST(BuryWalls, AStandingPlateBuriesTheMiddleOfItsFootprint) {
  const auto walls = walls_beside(test::box_of({0.02, 0}, {0.07, 0.08}));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(walls.contains({i, -1}), i < 3 || i > 5) << i;
  for (int j = -1; j < 10; ++j) EXPECT_TRUE(walls.contains({-1, j}) && walls.contains({10, j}));
}

TEST(BuryWalls, ABodyInTheOpenBuriesNothing) {
  const auto walls = walls_beside(test::box_of({0.04, 0.04}, {0.06, 0.06}));
  EXPECT_EQ(walls.size(), 10u + 2 * 11);
}

}  // namespace
}  // namespace cosurge::fluid
