#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fluid_solver/mps.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/wall_layouts.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;
constexpr double depth = 0.2;

/// A tank with water and a beach of 30 degrees that ends on the floor.
v1::Fluid tank_with_beach() {
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.6, 0.3}), {test::box_of({0, 0}, {0.6, depth})});
  *fluid.add_obstacle()->mutable_shape() =
      test::outline_of<2>({{0.25, 0}, {0.6, 0}, {0.6, 0.35 * std::tan(0.5236)}});
  return fluid;
}

TEST(FittedWalls, ABeachGoesDownToTheFloorWithoutCrowdingIt) {
  Particles<2> particles;
  Walls<2>(water_from_case<2>(tank_with_beach(), Vec<2>::Zero()), 3).add_to(particles);
  double toe = 1, least = 1;
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] == Kind::wall && particles.x[i][1] > 0) toe = std::min(toe, particles.x[i][0]);
    for (int j = 0; j < i; ++j) least = std::min(least, (particles.x[i] - particles.x[j]).norm());
  }
  EXPECT_GT(least, 0.7 * l0);
  EXPECT_LT(toe, 0.25 + 2.5 * l0);  // half a spacing below a slope of 30 degrees is one beside it
}

TEST(FittedWalls, WaterRestsOnABeach) {
  constexpr double rho_g = 1000 * 9.81, end = 0.25, dt = 1e-3;
  auto mps = test::mps_of<2>(tank_with_beach(), nullptr, {0, -9.81});
  double error = 0;
  int count = 0;
  for (int k = 0; k * dt < end; ++k) {
    (void)mps.step(k * dt, dt);
    if (k * dt < 0.15) continue;
    const Particles<2>& particles = mps.particles();
    for (int i = 0; i < particles.size(); ++i) {
      const Vec<2>& x = particles.x[i];
      const double below = (x[0] - 0.25) * std::sin(0.5236) - x[1] * std::cos(0.5236);
      if (particles.kind[i] != Kind::wall || x[1] < 0 || x[1] > depth - 3 * l0) continue;
      if (std::abs(below - 0.5 * l0) > 0.02 * l0) continue;
      error += std::pow(particles.p[i] - rho_g * (depth - x[1]), 2);
      ++count;
    }
  }
  ASSERT_GT(count, 1000);
  const double share = std::sqrt(error / count) / (rho_g * depth);
  EXPECT_LT(share, 0.05);
  double fastest = 0;
  for (int i = 0; i < mps.particles().size(); ++i) fastest = std::max(fastest, mps.particles().u[i].norm());
  EXPECT_LT(fastest, 0.2);  // sqrt(2 g depth) is 2 m/s
}

}  // namespace
}  // namespace cosurge::fluid
