#include "fluid_solver/surface_damping.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 1;
constexpr double n0 = 6.54;  // for the square lattice at 2.1 spacings
constexpr SurfaceDamping damping{.thin = 0.8 * n0, .share = 0.2};

/// A round drop of uneven particles with their number density; velocity(x) gives what each does.
template <typename Velocity>
test::Cloud<2> drop(Velocity&& velocity) {
  test::Cloud<2> cloud{.particles = {}, .neighbors = Neighbors<2>({{-10, -10}, {10, 10}}, 2.1 * l0)};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uneven(-0.2, 0.2);
  for (int i = -5; i <= 5; ++i)
    for (int j = -5; j <= 5; ++j)
      if (i * i + j * j <= 25) cloud.particles.add(Kind::fluid, {i + uneven(random), j + uneven(random)});
  cloud.neighbors.rebuild(cloud.particles);
  for (int k = 0; k < cloud.particles.size(); ++k) {
    cloud.particles.u[k] = velocity(cloud.particles.x[k]);
    double n = 0;
    cloud.neighbors.each(cloud.particles, k,
                         [&](int, const Vec<2>&, double r) { n += weight(r, cloud.neighbors.re()); });
    cloud.particles.n[k] = n;
  }
  return cloud;
}

std::vector<Vec<2>> changes(const test::Cloud<2>& cloud) {
  std::vector<Vec<2>> change;
  for (int i = 0; i < cloud.particles.size(); ++i)
    change.push_back(damp_surface(cloud.particles, cloud.neighbors, i, n0, damping));
  return change;
}

double spin(const Vec<2>& x, const Vec<2>& u) { return x[0] * u[1] - x[1] * u[0]; }

TEST(SurfaceDamping, KeepsMomentumAndAngularMomentumAndTakesEnergy) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  const auto cloud = drop([&](const Vec<2>&) { return Vec<2>(noise(random), noise(random)); });
  const auto change = changes(cloud);
  Vec<2> momentum = Vec<2>::Zero();
  double turn = 0, before = 0, after = 0;
  for (int i = 0; i < cloud.particles.size(); ++i) {
    momentum += change[i];
    turn += spin(cloud.particles.x[i], change[i]);
    before += cloud.particles.u[i].squaredNorm();
    after += (cloud.particles.u[i] + change[i]).squaredNorm();
  }
  EXPECT_LT(momentum.norm(), 1e-12);  // rounding of some 80 sums of order 1
  EXPECT_NEAR(turn, 0, 1e-12);
  EXPECT_LT(after, 0.97 * before);
}

TEST(SurfaceDamping, LeavesRigidMotionAlone) {
  const auto cloud = drop([](const Vec<2>& x) { return Vec<2>(3 - 2 * x[1], 1 + 2 * x[0]); });
  for (const Vec<2>& change : changes(cloud)) EXPECT_LT(change.norm(), 1e-12);
}

TEST(SurfaceDamping, ActsAtTheSurfaceAlone) {
  // Uniform compression: every pair approaches.
  const auto cloud = drop([](const Vec<2>& x) { return Vec<2>(-x); });
  const auto change = changes(cloud);
  for (int i = 0; i < cloud.particles.size(); ++i) {
    const double radius = cloud.particles.x[i].norm();
    if (radius < 2) {
      EXPECT_EQ(change[i].norm(), 0) << radius;
    }
    if (radius > 4.8) {
      EXPECT_GT(change[i].dot(cloud.particles.x[i]), 0) << radius;
    }
  }
}

TEST(SurfaceDamping, IsHalfOfTheSpeedOverTheSpacingAndStableInLongSteps) {
  EXPECT_DOUBLE_EQ(surface_damping(n0, 2, 0.01, 1e-4).share, 0.01);
  EXPECT_DOUBLE_EQ(surface_damping(n0, 2, 0.01, 1).share, 0.3);
}

}  // namespace
}  // namespace cosurge::fluid
