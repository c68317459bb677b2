// The height of the water's surface, beside walls and under spray.
#include "fluid_solver/water_level.hpp"

#include <gtest/gtest.h>

#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;

/// Boxes of water in a tank of 0.3 m.
double level(double x, const std::vector<v1::Box>& water) {
  const auto mps =
      test::mps_of<2>(test::tank_of_water(l0, test::box_of({0, 0}, {0.3, 0.3}), water), nullptr, {0, -9.81});
  return level_over<2>(mps, connected_water(mps, l0), {.foot = {x, 0}, .up = {0, 1}}, l0);
}

v1::Box pool(double depth) { return test::box_of({0, 0}, {0.3, depth}); }

TEST(WaterLevel, FindsTheSurfaceInTheMiddleAndBesideWalls) {
  // Half a support of water: the surface of the lattice, to what a sum over some 13 sites can tell.
  for (const double x : {0.0, 0.005, 0.1, 0.153, 0.3})
    EXPECT_NEAR(level(x, {pool(0.1)}), 0.1, 0.15 * l0) << x;
}

TEST(WaterLevel, RisesWithTheWater) {
  EXPECT_NEAR(level(0.105, {pool(0.15)}) - level(0.105, {pool(0.1)}), 0.05, 1e-12);
}

TEST(WaterLevel, DoesNotSeeWaterInTheAirHoweverMuch) {
  for (const double side : {0.01, 0.04, 0.08})
    EXPECT_EQ(level(0.105, {pool(0.1), test::box_of({0.1, 0.2}, {0.1 + side, 0.2 + side})}),
              level(0.105, {pool(0.1)}))
        << side;
}

TEST(WaterLevel, OfEveryBasinIsItsOwn) {
  // A wall of air, 0.05 m thick, between two pools of different depth and size.
  const std::vector<v1::Box> basins = {test::box_of({0, 0}, {0.2, 0.1}),
                                       test::box_of({0.25, 0}, {0.3, 0.16})};
  EXPECT_NEAR(level(0.1, basins), 0.1, 0.15 * l0);
  EXPECT_NEAR(level(0.275, basins), 0.16, 0.15 * l0);
}

TEST(WaterLevel, IsTheFloorWhereThereIsNoWaterOrOnlySpray) {
  EXPECT_EQ(level(0.2, {test::box_of({0, 0}, {0.1, 0.1})}), 0);
  EXPECT_EQ(level(0.21, {test::box_of({0, 0}, {0.1, 0.1}), test::box_of({0.19, 0.1}, {0.23, 0.14})}), 0);
}

}  // namespace
}  // namespace cosurge::fluid
