// Prescribed motions of walls and holders.
#include "common/geometry/motion.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace cosurge {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// The velocity is a difference over 1e-6 s, which must not reach back to before the start.
TEST(Motion, BeginsWithItsSpeed) {
  Pose<2> amplitude = Pose<2>::Zero();
  amplitude[0] = 0.1;
  const Motion<2> formula({.amplitude = amplitude, .frequency = 2, .phase = 0, .ramp = 0}, Vec<2>::Zero());
  Pose<2> end = Pose<2>::Zero();
  end[1] = -6;
  const Motion<2> table({.time = {0, 2}, .row = {Pose<2>::Zero(), end}}, Vec<2>::Zero());
  const Motion<2> uniform(Vec<2>(3, -4));
  for (const double t : {0.0, 1e-9, 5e-7, 2e-6, 1e-4}) {
    EXPECT_NEAR(formula.velocity({1, 1}, t)[0], 0.1 * two_pi * 2, 1e-5) << t;
    EXPECT_NEAR(table.velocity({1, 1}, t)[1], -3, 1e-8) << t;
    EXPECT_LT((uniform.velocity({1, 1}, t) - Vec<2>(3, -4)).norm(), 1e-8) << t;
  }
}

TEST(Motion, OfConstantVelocityGoesOnForEver) {
  const Motion<3> uniform(Vec<3>(1, 2, -3));
  EXPECT_TRUE(uniform.moves());
  EXPECT_LT((uniform.place({1, 1, 1}, 100) - Vec<3>(101, 201, -299)).norm(), 1e-12);
  EXPECT_FALSE(Motion<3>(Vec<3>::Zero()).moves());
}

}  // namespace
}  // namespace cosurge
