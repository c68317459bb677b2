#include "common/geometry/body_sites.hpp"

#include <gtest/gtest.h>

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

TEST(BodySites, AtASharpTipEverySiteIsOneOfABlock) {
  const BodySites<2> sites(from_case<2>(test::outline<2>({{0, 0}, {1, 0}, {0, 0.2}})), l0);
  const auto count = static_cast<double>(sites.all().size());
  // The slope of 1 in 5 leaves out part of the top row of each column, and at the tip the last row.
  EXPECT_NEAR(count * l0 * l0, 0.1, 0.0105);
  for (const Vec<2>& x : sites.all()) {
    bool in_block = false;
    for (const double i : {-l0, l0})
      for (const double j : {-l0, l0})
        in_block = in_block || (sites.contains(x + Vec<2>(i, 0)) && sites.contains(x + Vec<2>(0, j)) &&
                                sites.contains(x + Vec<2>(i, j)));
    EXPECT_TRUE(in_block) << x.transpose();
    EXPECT_TRUE(sites.contains(x));
  }
}

// Sites on the faces: rounding must not decide, or the faces get bumps.
TEST(BodySites, OnFacesAreTakenByTheSideOfTheBody) {
  for (const double shift : {0.0, 0.1, 0.3, 1000.0}) {
    const double c = shift + 0.105;  // a site
    const BodySites<2> diamond(
        from_case<2>(test::outline<2>({{c - 0.1, c}, {c, c - 0.1}, {c + 0.1, c}, {c, c + 0.1}})), l0);
    // 181 sites inside and 19 on the lower faces, less the upper and the lower corner, which belong to no
    // block.
    EXPECT_EQ(diamond.all().size(), 198u) << shift;
    for (const Vec<2>& x : diamond.all())
      EXPECT_TRUE(diamond.contains({2 * c - x[0], x[1]})) << "not symmetric at " << x.transpose();
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
