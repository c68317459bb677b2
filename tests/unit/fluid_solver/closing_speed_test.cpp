// How fast bodies are driven into the water.
#include "fluid_solver/closing_speed.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "fluid_solver/mps.hpp"
#include "fluid_solver/rigid_motion.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using test::box_of;

constexpr double l0 = 0.01;

TEST(RigidMotion, OfARigidBodyIsItsMotion) {
  std::vector<Vec<3>> x, u;
  const Vec<3> v(1, -2, 3), spin(0.3, -0.7, 2);
  for (int k = 0; k < 20; ++k) {
    x.emplace_back(std::sin(k), std::cos(2.1 * k), std::sin(3.3 * k) + 5);
    u.push_back(v + spin.cross(x.back()));
  }
  const RigidMotion<3> motion = rigid_motion<3>(x, u);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_LT((motion.at(x[k]) - u[k]).norm(), 1e-12);
}

TEST(RigidMotion, OfAStretchIsTheMeanVelocity) {
  const std::vector<Vec<2>> x = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  const std::vector<Vec<2>> u = {{0, 7}, {2, 7}, {0, 7}, {2, 7}};
  const RigidMotion<2> motion = rigid_motion<2>(x, u);
  for (const Vec<2>& at : x) EXPECT_LT((motion.at(at) - Vec<2>(1, 7)).norm(), 1e-12);
}

/// A box that touches the surface of water.
class DrivenBox : public testing::Test {
 protected:
  /// Speed at which the box, moved at `body`, closes on water that moves at `water`.
  double closes(const Vec<2>& body, const Vec<2>& water, bool clamped = false) const {
    const v1::Fluid fluid = test::tank_of_water(l0, box_of({0, 0}, {0.6, 0.6}), {box_of({0, 0}, {0.6, 0.2})});
    const v1::Box box = box_of({0.2, 0.2}, {0.4, 0.3});
    const v1::Solid solid =
        clamped ? test::solid_of(box, {box_of({0.2, 0.3}, {0.4, 0.34})}) : test::solid_of(box, {});
    auto mps = test::mps_of<2>(fluid, &solid, {0, 0});
    (void)mps.step(0, 1e-6);
    Particles<2> particles = mps.particles();
    std::vector<std::int32_t> place(static_cast<std::size_t>(mps.bodies().points()));
    const int first = mps.initial_size() - mps.bodies().points();
    for (int i = 0; i < particles.size(); ++i) {
      if (particles.kind[i] == Kind::fluid) particles.u[i] = water;
      if (particles.id[i] < first) continue;
      particles.u[i] = body;
      place[static_cast<std::size_t>(particles.id[i] - first)] = i;
    }
    const auto faces = mps.bodies().deformed(Field::Zero(2, mps.bodies().points()));
    return closing_speed<2>({.bodies = mps.bodies(), .normal = faces.normal, .place = place}, particles,
                            mps.neighbors(), mps.walls(), 1e-3, 1e-3);
  }
};

TEST_F(DrivenBox, ClosesOnWaterAtRestAtItsSpeedAcrossTheFace) {
  EXPECT_NEAR(closes({0, -3}, {0, 0}), 3, 1e-9);
  EXPECT_LT(closes({0, 3}, {0, 0}), 1e-9);  // it leaves
}

TEST_F(DrivenBox, ThatIsAtRestIsNotDriven) { EXPECT_LT(closes({0, 0}, {0, 3}), 1e-9); }

TEST_F(DrivenBox, ThatDriftsWithTheWaterIsNotDriven) { EXPECT_LT(closes({1, -3}, {1, -3}), 1e-9); }

TEST_F(DrivenBox, ThatClampsHoldAtRestIsNotDriven) { EXPECT_EQ(closes({0, -3}, {0, 0}, true), 0); }

}  // namespace
}  // namespace cosurge::fluid
