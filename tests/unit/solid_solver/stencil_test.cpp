#include "solid_solver/models/particles/stencil.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cosurge::particles {
namespace {

TEST(Stencil, ReferenceDensityIsTheHandSum) {
  const Stencil<2> stencil = full_stencil<2>(0.001, 2.1);
  const double hand = 4 * weight(1, 2.1) + 4 * weight(std::sqrt(2.0), 2.1) + 4 * weight(2, 2.1);
  EXPECT_EQ(stencil.neighbors.size(), 12u);
  EXPECT_NEAR(stencil.n0, hand, 1e-14);    // twelve terms of order one
  EXPECT_NEAR(stencil.n0, 6.53970, 5e-6);  // the digits printed in the literature
}

TEST(Stencil, SitesExactlyAtTheRadiusAreNoNeighbours) {
  EXPECT_EQ(full_stencil<2>(0.001, 2.0).neighbors.size(), 8u);
  EXPECT_EQ(full_stencil<2>(0.001, 3.0).neighbors.size(), 24u);
}

TEST(Stencil, NeighboursComeInTheOrderOfTheLattice) {
  const Stencil<2> stencil = full_stencil<2>(1, 2.1);
  for (std::size_t k = 1; k < stencil.neighbors.size(); ++k) {
    const auto &a = stencil.neighbors[k - 1].offset, &b = stencil.neighbors[k].offset;
    EXPECT_TRUE(a[1] < b[1] || (a[1] == b[1] && a[0] < b[0]));
  }
}

TEST(HighestFrequency, IsTheRotationOfTheParticlesForOrdinaryMaterials) {
  for (const double nu : {0.0, 0.3, 0.45}) {
    const Elasticity material{.density = 7800, .young_modulus = 2e8, .poisson_ratio = nu};
    const double omega = highest_frequency(full_stencil<2>(0.001, 2.1), material);
    EXPECT_NEAR(omega / (std::sqrt(24.0) * material.shear_speed() / 0.001), 1, 1e-14);  // the same formula
  }
}

// The full eigenvalue problem of the infinite lattice, rotation included, solved once over an 80 x 80 grid of
// wave vectors: omega^2 = 58.00 and 112.36 mu / (rho l0^2).
TEST(HighestFrequency, IsThatOfPressureWavesForNearlyIncompressibleMaterials) {
  const double bloch[] = {58.00, 112.36};
  const double ratio[] = {0.49, 0.495};
  for (int k = 0; k < 2; ++k) {
    const Elasticity material{.density = 1000, .young_modulus = 1e6, .poisson_ratio = ratio[k]};
    const double omega =
        highest_frequency(full_stencil<2>(0.001, 2.1), material) * 0.001 / material.shear_speed();
    EXPECT_NEAR(omega * omega / bloch[k], 1.15, 2e-3);  // both grids miss the maximum by less than 1e-3
  }
}

}  // namespace
}  // namespace cosurge::particles
