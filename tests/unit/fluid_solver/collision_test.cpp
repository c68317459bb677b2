#include "fluid_solver/collision.hpp"

#include <gtest/gtest.h>

#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr CollisionLaw law{.distance = 0.85, .restitution = 0.2, .spacing = 1};

/// Two particles, the first a fluid one at the origin.
test::Cloud<2> pair(const Vec<2>& x, Kind kind, const Vec<2>& u0, const Vec<2>& u1) {
  test::Cloud<2> cloud{.particles = {}, .neighbors = Neighbors<2>({{-1, -1}, {20, 20}}, 2.1)};
  cloud.particles.add(Kind::fluid, {0, 0});
  cloud.particles.add(kind, x);
  cloud.particles.u = {u0, u1};
  cloud.neighbors.rebuild(cloud.particles);
  return cloud;
}

Vec<2> change(const test::Cloud<2>& cloud, int id) {
  const auto& ids = cloud.particles.id;
  const auto place = static_cast<int>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  return collision(cloud.particles, cloud.neighbors, place, law, [](int, const Vec<2>&) {});
}

TEST(Collision, APairKeepsItsMomentumAndReversesAFifthOfItsApproach) {
  const Vec<2> x(0.48, 0.36);
  const Vec<2> along = x / x.norm();
  const Vec<2> u0(1.3, -0.4);
  const Vec<2> u1(-0.7, 0.2);
  const auto cloud = pair(x, Kind::fluid, u0, u1);
  const Vec<2> d0 = change(cloud, 0);
  const Vec<2> d1 = change(cloud, 1);
  const double before = (u0 - u1).dot(along);
  ASSERT_GT(before, 0);
  EXPECT_LT((d0 + d1).norm(), 1e-15);                                             // the same product, twice
  EXPECT_NEAR((u0 + d0 - u1 - d1).dot(along), -law.restitution * before, 1e-15);  // rounding
  EXPECT_NEAR(Vec<2>(-along[1], along[0]).dot(d0), 0, 1e-15);                     // nothing across
}

TEST(Collision, AWallGivesTheWholeChangeToTheWater) {
  for (const Kind kind : {Kind::wall, Kind::dummy, Kind::body_surface, Kind::body_inner}) {
    const auto cloud = pair({0.5, 0}, kind, {1, 2}, {-0.5, 0});
    const Vec<2> after = Vec<2>(1, 2) + change(cloud, 0);
    EXPECT_NEAR(after[0] - (-0.5), -law.restitution * 1.5, 1e-15);
    EXPECT_EQ(after[1], 2);
  }
}

/// Water at the origin and a wall of five particles with the normal +x, its face at x = -`gap`.
test::Cloud<2> beside_face(double gap, const Vec<2>& u) {
  test::Cloud<2> cloud{.particles = {}, .neighbors = Neighbors<2>({{-9, -9}, {9, 9}}, 2.1)};
  cloud.particles.add(Kind::fluid, {0, 0});
  for (int k = -2; k <= 2; ++k) {
    cloud.particles.add(Kind::wall, {-gap - 0.5, k + 0.3});
    cloud.particles.normal.back() = {1, 0};
  }
  cloud.particles.u[0] = u;
  cloud.neighbors.rebuild(cloud.particles);
  return cloud;
}

TEST(Collision, WaterThatReachesAFaceLosesItsSpeedAcrossItOnceAndSlidesFreely) {
  const Vec<2> after = Vec<2>(-1, 7) + change(beside_face(-0.01, {-1, 7}), 0);
  EXPECT_NEAR(after[0], law.restitution * 1, 1e-15);
  EXPECT_EQ(after[1], 7);
  EXPECT_EQ(change(beside_face(0.01, {-1, 7}), 0), (Vec<2>(0, 0)));  // not there yet
  EXPECT_EQ(change(beside_face(-0.01, {1, 7}), 0), (Vec<2>(0, 0)));  // moves away from the face
}

TEST(Collision, WaterOnTopOfAnEdgeIsNotHeldByTheFaceAroundIt) {
  test::Cloud<2> cloud{.particles = {}, .neighbors = Neighbors<2>({{-9, -9}, {9, 9}}, 2.1)};
  cloud.particles.add(Kind::fluid, {0, 0});
  cloud.particles.add(Kind::wall, {-0.2, -1});  // behind the vertical face of an edge below the water
  cloud.particles.normal.back() = {1, 0};
  cloud.particles.u[0] = {-1, 0};
  cloud.neighbors.rebuild(cloud.particles);
  EXPECT_EQ(change(cloud, 0), (Vec<2>(0, 0)));
}

TEST(Collision, LeavesSeparatingAndDistantPairsAlone) {
  EXPECT_EQ(change(pair({0.5, 0}, Kind::fluid, {-1, 0}, {1, 0}), 0), (Vec<2>(0, 0)));
  EXPECT_EQ(change(pair({0.5, 0}, Kind::fluid, {1, 3}, {1, -3}), 0), (Vec<2>(0, 0)));  // passing by
  EXPECT_EQ(change(pair({0.86, 0}, Kind::fluid, {1, 0}, {-1, 0}), 0), (Vec<2>(0, 0)));
}

TEST(Collision, ParticlesInOnePlaceHaveNoDirectionAndDoNotCollide) {
  EXPECT_EQ(change(pair({0, 0}, Kind::fluid, {1, 0}, {-1, 0}), 0), (Vec<2>(0, 0)));
}

}  // namespace
}  // namespace cosurge::fluid
