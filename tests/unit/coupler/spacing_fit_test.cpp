// Fits over the spacing return the numbers that samples were made from.
#include "coupler/converge/spacing_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr double limit = 5, slope = 200;  // 4 % at 1 mm

TEST(SpacingFit, FindsLimitAndErrorOfALine) {
  std::vector<SpacingSample> samples;
  for (const double h : {0.004, 0.003, 0.002}) samples.push_back({h, limit + slope * h, 0});
  const SpacingFit fit(samples);
  EXPECT_NEAR(fit.limit(), limit, 1e-12);
  EXPECT_NEAR(fit.error(0.001), 0.04, 1e-12);
  EXPECT_NEAR(fit.scatter(), 0, 1e-12);
  EXPECT_NEAR(fit.spacing_for(0.01), 0.00025, 1e-12);
}

TEST(SpacingFit, HasNoSpacingForLessThanTheScatter) {
  // Two starts a spacing, 1 % of the limit apart: four degrees of freedom, six deviations of half a percent.
  std::vector<SpacingSample> samples;
  for (const double h : {0.004, 0.003, 0.002})
    for (const double side : {-0.5, 0.5}) samples.push_back({h, limit + slope * h + side * 0.01 * limit, 0});
  const SpacingFit fit(samples);
  const double scatter = 0.005 * std::sqrt(6.0 / 4);
  EXPECT_NEAR(fit.scatter(), scatter, 1e-12);
  EXPECT_EQ(fit.spacing_for(0.99 * scatter), 0);
  EXPECT_NEAR(fit.error(fit.spacing_for(0.03)), 0.03, 1e-12);
  EXPECT_NEAR(fit.error(0.001), std::hypot(0.04, scatter), 1e-12);
}

TEST(SpacingFit, OfANegativeQuantityHasPositiveErrors) {
  const SpacingFit fit({{0.004, -6, 0}, {0.003, -5.75, 0}, {0.002, -5.5, 0}});
  EXPECT_NEAR(fit.limit(), -5, 1e-12);
  EXPECT_NEAR(fit.error(0.002), 0.1, 1e-12);
}

// A quantity of second order: the line says more than the true error at every finer spacing.
TEST(SpacingFit, DoesNotPromiseTooMuchForAHigherOrder) {
  const auto value = [](double h) { return limit * (1 + 0.04 * std::pow(h / 0.002, 2)); };
  const SpacingFit fit({{0.004, value(0.004), 0}, {0.002667, value(0.002667), 0}, {0.002, value(0.002), 0}});
  for (const double h : {0.002, 0.001, 0.0005}) EXPECT_GT(fit.error(h), std::abs(value(h) / limit - 1)) << h;
}

TEST(SpacingFit, NeedsThreeRunsAtTwoSpacings) {
  EXPECT_THROW(SpacingFit({{0.002, 1, 0}, {0.001, 1, 0}}), Error);
  EXPECT_THROW(SpacingFit({{0.002, 1, 0}, {0.002, 2, 0}, {0.002, 3, 0}}), Error);
}

TEST(CostFit, FollowsTheTwoFinestSpacings) {
  const auto seconds = [](double h) { return 8 * std::pow(0.002 / h, 3.2); };
  const CostFit fit({{0.004, 0, 5}, {0.003, 0, seconds(0.003)}, {0.002, 0, seconds(0.002)}}, 2);
  EXPECT_NEAR(fit.core_seconds(0.001), seconds(0.001), 1e-9);
  EXPECT_NEAR(fit.spacing_for(seconds(0.0007)), 0.0007, 1e-12);
}

TEST(CostFit, StaysNearTheCostOfStepsAndParticles) {
  // A machine that was busy at the coarser spacing: no run becomes cheaper on a finer lattice.
  const CostFit plane({{0.002, 0, 10}, {0.001, 0, 9}}, 2), space({{0.002, 0, 1}, {0.001, 0, 1000}}, 3);
  EXPECT_NEAR(plane.core_seconds(0.0005), 9 * 4, 1e-9);
  EXPECT_NEAR(space.core_seconds(0.0005), 1000 * 32, 1e-6);
}

}  // namespace
}  // namespace cosurge
