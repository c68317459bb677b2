// Water slides along walls: the divergence does not see how fast.
#include <gtest/gtest.h>

#include "fluid_solver/operators.hpp"
#include "tests/support/pressure_tank.hpp"

namespace cosurge::fluid {
namespace {

using test::l0;
using test::Tank;

/// Largest divergence beside the floor, away from the side walls, in water that runs along it at one speed.
double beside_floor(Tank<2>& tank, double speed) {
  auto& particles = tank.cloud.particles;
  const ReferenceValues reference = reference_values<2>(2.1 * l0, l0);
  for (int i = 0; i < particles.size(); ++i)
    particles.u[i] = particles.kind[i] == Kind::fluid ? Vec<2>(speed, 0) : Vec<2>(0, 0);
  double largest = 0;
  for (int i = 0; i < particles.size(); ++i) {
    const Vec<2>& x = particles.x[i];
    if (!has_pressure(particles.kind[i]) || x[1] > 3 * l0 || std::abs(x[0] - 0.06) > 0.02) continue;
    const double d = divergence<2>(particles, tank.cloud.neighbors, i, reference, Vec<2>::Zero());
    largest = std::max(largest, std::abs(d));
  }
  return largest;
}

TEST(Slip, WaterThatRunsAlongAWallHasNoDivergenceHoweverUnevenItLies) {
  Tank<2> tank({.disorder = 0.2});
  EXPECT_LT(beside_floor(tank, 10), 1e-9 * 10 / l0);
  for (auto& normal : tank.cloud.particles.normal) normal.setZero();  // as if walls took the water along
  EXPECT_GT(beside_floor(tank, 10), 0.03 * 10 / l0);
}

TEST(Slip, TheEquationsOwnDivergenceDoesNotSeeItEither) {
  Tank<2> tank({.disorder = 0.2});
  auto& particles = tank.cloud.particles;
  for (int i = 0; i < particles.size(); ++i)
    particles.u[i] = particles.kind[i] == Kind::fluid ? Vec<2>(10, 0) : Vec<2>(0, 0);
  const auto wide = tank.equation.divergence(particles, tank.cloud.neighbors.grid(), Vec<2>::Zero());
  int known = 0;
  for (std::size_t k = 0; k < wide.size(); ++k) {
    const Vec<2>& x = particles.x[tank.equation.unknowns()[k]];
    if (std::isnan(wide[k]) || x[1] > 2.5 * l0 || std::abs(x[0] - 0.06) > 0.015) continue;
    ++known;
    EXPECT_LT(std::abs(wide[k]), 1e-6 * 10 / l0);
  }
  EXPECT_GT(known, 4);
}

TEST(Slip, AWallThatMovesIntoTheWaterIsSeenInFull) {
  Tank<2> tank({});
  auto& particles = tank.cloud.particles;
  const ReferenceValues reference = reference_values<2>(2.1 * l0, l0);
  for (int i = 0; i < particles.size(); ++i)
    particles.u[i] = particles.kind[i] == Kind::fluid ? Vec<2>(0, 0) : Vec<2>(3, 1);  // 3 along, 1 across
  double flux = 0;  // what the floor's column of particles has of it, per area
  for (int i = 0; i < particles.size(); ++i)
    if (has_pressure(particles.kind[i]) && std::abs(particles.x[i][0] - 0.055) < 1e-6 &&
        particles.x[i][1] < 0.1)
      flux -= l0 * divergence<2>(particles, tank.cloud.neighbors, i, reference, Vec<2>::Zero());
  EXPECT_NEAR(flux, 1, 0.025);  // the second layer of dummies, which has no row, would have the last 2.2 %
}

}  // namespace
}  // namespace cosurge::fluid
