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

}  // namespace
}  // namespace cosurge::particles
