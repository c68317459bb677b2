#include "solid_solver/models/fem/outline_features.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "common/case/from_case.hpp"
#include "solid_solver/models/fem/shape_axes.hpp"
#include "tests/support/outlines.hpp"

namespace cosurge::fem {
namespace {

OutlineFeatures<3> features_of(const v1::Shape& shape) { return OutlineFeatures<3>(from_case<3>(shape)); }

TEST(OutlineFeatures, OfAPrismAreItsCornersEdgesAndFaces) {
  const OutlineFeatures<3> prism = features_of(test::prism(1, 2, 3));
  EXPECT_EQ(prism.corners.size(), 6u);
  EXPECT_EQ(prism.creases.size(), 9u);
  EXPECT_EQ(prism.patches.size(), 5u);
  double length = 0;
  for (const Crease& crease : prism.creases) {
    length += crease.length();
    for (const std::size_t end : {0, 1})
      EXPECT_EQ(crease.at(static_cast<double>(end)), prism.corners[crease.ends[end]]);
  }
  EXPECT_NEAR(length, 2 * (1 + 2 + std::sqrt(5.0)) + 3 * 3, 1e-14);  // rounding
}

TEST(OutlineFeatures, OfACylinderAreTwoRingsInPartsAndThreeFaces) {
  std::vector<Vec<2>> rim;
  for (int k = 0; k < 48; ++k)
    rim.emplace_back(std::cos(k * std::numbers::pi / 24), std::sin(k * std::numbers::pi / 24));
  const OutlineFeatures<3> cylinder = features_of(test::extruded(rim, 2));
  EXPECT_EQ(cylinder.corners.size(), 8u);
  EXPECT_EQ(cylinder.creases.size(), 8u);
  EXPECT_EQ(cylinder.patches.size(), 3u);
  for (const Crease& crease : cylinder.creases) {
    EXPECT_NE(crease.ends[0], crease.ends[1]);
    EXPECT_NEAR(crease.length(), 24 * std::sin(std::numbers::pi / 48), 1e-14);  // a quarter: 12 chords
    EXPECT_NEAR(crease.distance({0, 0, crease.points[0][2]}), std::cos(std::numbers::pi / 48), 1e-14);
  }
}

TEST(AxesOf, ABracketAreItsFacesHoweverItIsTurned) {
  // Its principal axes are at 45 degrees to its faces.
  const std::vector<Vec<2>> corners = {{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}};
  for (const double angle : {0.0, 0.4}) {
    Mat<2> turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    std::vector<Vec<2>> turned;
    for (const Vec<2>& x : corners) turned.emplace_back(turn * x);
    EXPECT_LT((axes_of(from_case<2>(test::outline<2>(turned))) - turn).norm(), 1e-14);  // rounding
  }
  EXPECT_LT((axes_of(from_case<3>(test::extruded(corners, 0.5, 3))) - Mat<3>::Identity()).norm(), 1e-14);
}

}  // namespace
}  // namespace cosurge::fem
