// Water slides along walls: the divergence does not depend on the velocity along them.
#include <gtest/gtest.h>

#include "tests/support/pressure_tank.hpp"

namespace cosurge::fluid {
namespace {

using test::l0;
using test::Tank;

/// Largest divergence beside the floor, away from side walls and surface, in water that runs along it.
double beside_floor(Tank<2>& tank, double speed) {
  auto& particles = tank.cloud.particles;
  for (int i = 0; i < particles.size(); ++i)
    particles.u[i] = particles.kind[i] == Kind::fluid ? Vec<2>(speed, 0) : Vec<2>(0, 0);
  const auto divergence = tank.equation.divergence(particles, tank.cloud.neighbors.grid(), Vec<2>::Zero());
  double largest = 0;
  for (std::size_t m = 0; m < divergence.size(); ++m) {
    const Vec<2>& x = particles.x[tank.equation.unknowns()[m]];
    if (x[1] > 4 * l0 || std::abs(x[0] - 0.06) > 0.015) continue;
    largest = std::max(largest, std::abs(divergence[m]));
  }
  return largest;
}

TEST(Slip, WaterThatRunsAlongAWallHasNoDivergenceHoweverUnevenItLies) {
  Tank<2> tank({.disorder = 0.2, .open_surface = true});
  EXPECT_LT(beside_floor(tank, 10), 1e-6 * 10 / l0);
  for (auto& normal : tank.cloud.particles.normal)
    normal.setZero();  // without normals: as if walls dragged the water along
  EXPECT_GT(beside_floor(tank, 10), 0.02 * 10 / l0);
}

/// Divergence caused by a motion of the floor, in units of the floor's speed: the sum over the rows of a
/// column of particles above the floor and the floor's own row; and the share of the floor's own row.
template <int dim>
std::pair<double, double> flux_of_floor(double along) {
  Tank<dim> tank({.water = 0.16, .open_surface = true});
  auto& particles = tank.cloud.particles;
  Vec<dim> u = Vec<dim>::Zero();
  u[0] = along;
  u[dim - 1] = 1;
  // Side walls move with the floor, and have no divergence against it.
  for (int i = 0; i < particles.size(); ++i)
    particles.u[i] = particles.kind[i] == Kind::fluid ? Vec<dim>::Zero() : u;
  const auto divergence = tank.equation.divergence(particles, tank.cloud.neighbors.grid(), Vec<dim>::Zero());
  double all = 0, floor = 0;
  for (std::size_t m = 0; m < divergence.size(); ++m) {
    const int i = tank.equation.unknowns()[m];
    Vec<dim> aside = particles.x[i] - Vec<dim>::Constant(0.055);
    aside[dim - 1] = 0;
    if (aside.norm() > 1e-6 || particles.x[i][dim - 1] > 0.1) continue;
    all -= l0 * divergence[m];
    if (particles.kind[i] == Kind::wall) floor -= l0 * divergence[m];
  }
  return {all, floor};
}

// A plane wall that is suddenly set in motion causes the flux of eq. (10c) through each column of matrix
// rows, the speed of the wall. So the pressure above the rows that interact with the wall equals the exact
// solution.
TEST(Slip, TheMomentumThatAWallGivesByASuddenMotionIsExact) {
  for (const double along : {0.0, 3.0}) {
    EXPECT_NEAR(flux_of_floor<2>(along).first, 1, 1e-5);
    EXPECT_NEAR(flux_of_floor<3>(along).first, 1, 1e-5);
  }
  EXPECT_GT(flux_of_floor<2>(0).second, 0.3);  // most of it at the wall itself
}

// Flow against a wall: the water moves aside along it without compression.
TEST(Slip, FlowThatTurnsAsideAtAWallHasHardlyAnyDivergence) {
  Tank<2> tank({.open_surface = true});
  auto& particles = tank.cloud.particles;
  constexpr double rate = 5;
  for (int i = 0; i < particles.size(); ++i) {
    const Vec<2> x = particles.x[i] - Vec<2>(0.06, 0);  // the floor's face is at 0
    particles.u[i] = particles.kind[i] == Kind::fluid ? Vec<2>(rate * x[0], -rate * x[1]) : Vec<2>(0, 0);
  }
  const auto divergence = tank.equation.divergence(particles, tank.cloud.neighbors.grid(), Vec<2>::Zero());
  int rows = 0;
  for (std::size_t m = 0; m < divergence.size(); ++m) {
    const Vec<2>& x = particles.x[tank.equation.unknowns()[m]];
    if (x[1] > 4 * l0 || std::abs(x[0] - 0.06) > 0.015) continue;
    ++rows;
    EXPECT_NEAR(divergence[m], 0, 0.012 * rate) << x.transpose();
  }
  EXPECT_GT(rows, 10);
}

}  // namespace
}  // namespace cosurge::fluid
