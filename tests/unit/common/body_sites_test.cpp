#include "common/geometry/body_sites.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/outlines.hpp"

namespace cosurge {
namespace {

constexpr double l0 = 0.01;

TEST(BodySites, ABoxAndThePolygonOfItsCornersHaveTheSame) {
  const BodySites<2> of_box(from_case<2>(test::box({0.1, 0.2}, {0.14, 0.27})), l0),
      of_polygon(from_case<2>(test::turned_box({0.1, 0.2}, {0.14, 0.27}, 0)), l0);
  ASSERT_EQ(of_box.all().size(), 28u);
  EXPECT_EQ(of_box.all(), of_polygon.all());
}

/// Whether x and three sites around it are sites.
bool in_block(const BodySites<2>& sites, const Vec<2>& x) {
  for (const double i : {-l0, l0})
    for (const double j : {-l0, l0})
      if (sites.contains(x) && sites.contains(x + Vec<2>(i, 0)) && sites.contains(x + Vec<2>(0, j)) &&
          sites.contains(x + Vec<2>(i, j)))
        return true;
  return false;
}

TEST(BodySites, AtASharpTipEverySiteIsOneOfABlockOrBesideOneOnAFlatEnd) {
  const BodySites<2> sites(from_case<2>(test::outline<2>({{0, 0}, {1, 0}, {0, 0.2}})), l0);
  const auto count = static_cast<double>(sites.all().size());
  // The slope of 1 in 5 leaves out part of the top row of each column, and at the tip the last row.
  EXPECT_NEAR(count * l0 * l0, 0.1, 0.0105);
  for (const Vec<2>& x : sites.all()) {
    const bool on_flat_end = x[1] < l0 && in_block(sites, x - Vec<2>(l0, 0));
    EXPECT_TRUE(in_block(sites, x) || on_flat_end) << x.transpose();
    EXPECT_TRUE(sites.contains(x));
  }
}

// The foot of a plate that leans on the floor is as wide as the plate: water under it would lift it
// otherwise.
TEST(BodySites, ALeaningPlateIsAsWideOnTheFloorAsAbove) {
  const BodySites<2> plate(from_case<2>(test::outline<2>({{0.1, 0}, {0.16, 0}, {0.36, 0.2}, {0.30, 0.2}})),
                           l0);
  std::map<long, int> rows;
  for (const Vec<2>& x : plate.all()) ++rows[std::lround(x[1] / l0 - 0.5)];
  EXPECT_EQ(rows.size(), 20u);
  for (const auto& [row, sites] : rows) EXPECT_NEAR(sites, 6, 1) << row;
  EXPECT_EQ(rows[0], rows[10]);
  EXPECT_EQ(rows[19], rows[10]);
}

// Sites on the faces: rounding must not decide, or the faces get bumps.
TEST(BodySites, OnFacesAreTakenAllAlike) {
  for (const double shift : {0.0, 0.1, 0.3, 1000.0}) {
    const double c = shift + 0.105;  // a site
    const BodySites<2> diamond(
        from_case<2>(test::outline<2>({{c - 0.1, c}, {c, c - 0.1}, {c + 0.1, c}, {c, c + 0.1}})), l0);
    // 21 rows of 1, 3, ... 21 ... 1 sites, less the four corners, which belong to no block.
    EXPECT_EQ(diamond.all().size(), 221u - 4u) << shift;
  }
}

TEST(BodySites, CountTheVolumeOfATetrahedron) {
  double error = 1;
  for (const double spacing : {0.1, 0.05, 0.025}) {
    const BodySites<3> sites(from_case<3>(test::tetrahedron(1, {0.2, 0.3, 0.1})), spacing);
    const double volume = static_cast<double>(sites.all().size()) * std::pow(spacing, 3);
    const double now = std::abs(volume * 6 - 1);
    EXPECT_LT(now, 0.75 * error);  // surface times spacing over volume: first order
    error = now;
    EXPECT_EQ(sites.parts(), 1);
  }
  EXPECT_LT(error, 0.15);
}

TEST(BodySites, ANeckThinnerThanABlockParts) {
  // Two squares of 5 sites joined by a strip of one.
  const auto dumbbell = from_case<2>(test::outline<2>({{0, 0},
                                                       {0.05, 0},
                                                       {0.05, 0.02},
                                                       {0.1, 0.02},
                                                       {0.1, 0},
                                                       {0.15, 0},
                                                       {0.15, 0.05},
                                                       {0.1, 0.05},
                                                       {0.1, 0.03},
                                                       {0.05, 0.03},
                                                       {0.05, 0.05},
                                                       {0, 0.05}}));
  EXPECT_EQ(BodySites<2>(dumbbell, l0).parts(), 2);
  EXPECT_EQ(BodySites<2>(dumbbell, 0.005).parts(), 1);
}

TEST(Shape, TheNearestPointOfATetrahedronLiesOnAFaceAnEdgeOrACorner) {
  const auto shape = from_case<3>(test::tetrahedron(1, {0, 0, 0}));
  EXPECT_LT((shape.nearest({0.2, 0.3, -0.1}) - Vec<3>(0.2, 0.3, 0)).norm(), 1e-15);
  EXPECT_LT((shape.nearest({0.4, -0.1, -0.1}) - Vec<3>(0.4, 0, 0)).norm(), 1e-15);
  EXPECT_LT((shape.nearest({-1, -1, -1}) - Vec<3>(0, 0, 0)).norm(), 1e-15);
  EXPECT_LT((shape.nearest({1, 1, 1}) - Vec<3>::Constant(1.0 / 3)).norm(), 1e-15);
  EXPECT_EQ(shape.outside({0.2, 0.2, 0.2}), 0);
  EXPECT_NEAR(shape.outside({0.2, 0.3, -0.1}), 0.1, 1e-15);
  EXPECT_NEAR(shape.share_outside({0.2, 0.2, -0.1}, {0, 0, 0.2}), 0.5, 1e-12);  // bisected 50 times
}

}  // namespace
}  // namespace cosurge
