// Order in time of the coupled solution: docs/stability.md, "Order in time".
#include <gtest/gtest.h>

#include "tests/support/piston_swing.hpp"

namespace cosurge::testing {
namespace {

constexpr double mu = 0.5;

double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

TEST(OrderInTime, OfWeakCouplingIsTwoInTheFrequencyAndOneInTheAmplitude) {
  const CouplingWords weak{.scheme = v1::Coupling::weak};
  const PistonSwing coarse = piston_swing(weak, mu, 50, 400), fine = piston_swing(weak, mu, 100, 400);
  EXPECT_NEAR(order(coarse.frequency, fine.frequency), 2, 0.1);  // the next order in the window, 2 pi / 50
  EXPECT_NEAR(order(coarse.lost, fine.lost), 1, 0.1);
  EXPECT_NEAR(fine.lost, 6.4e-2, 0.1e-2);  // docs/tables/coupling_theory.csv
}

TEST(OrderInTime, OfStrongCouplingIsTwoInTheFrequencyAndTheAmplitudeStays) {
  const CouplingWords strong{.scheme = v1::Coupling::strong};
  const PistonSwing coarse = piston_swing(strong, mu, 50, 400), fine = piston_swing(strong, mu, 100, 400);
  EXPECT_NEAR(order(coarse.frequency, fine.frequency), 2, 0.1);
  EXPECT_NEAR(fine.frequency, 8.2e-5, 0.1e-5);  // docs/tables/coupling_theory.csv
  EXPECT_LT(std::abs(fine.lost), 1e-6);         // the tolerance of 1e-11 in each of 1200 windows
}

TEST(OrderInTime, WhatTheSwingLosesIsTheWorkThatSchemeAndWaterDestroy) {
  constexpr int windows = 200;
  // A load -m_a dv / dt over a window works m_a dv^2 / 2 less than the kinetic energy of the water: in a
  // period pi omega dt of its share of the energy.
  const double by_water = 2 * std::pow(std::numbers::pi, 2) / windows * mu / (1 + mu);
  for (const auto scheme : {v1::Coupling::weak, v1::Coupling::strong})
    for (const auto velocity : {v1::Coupling::end, v1::Coupling::mean}) {
      const PistonSwing swing = piston_swing({scheme, velocity}, mu, windows, 400);
      const double left = std::pow(1 - swing.lost, 2);
      EXPECT_NEAR(swing.created - by_water, left - 1,
                  0.004);  // the amplitude falls by 5 % while it is measured
    }
}

}  // namespace
}  // namespace cosurge::testing
