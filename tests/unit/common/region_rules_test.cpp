#include "common/case/region_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/case_text.hpp"

namespace cosurge {
namespace {

using testing::CaseText;
using testing::errors_of;
using ::testing::HasSubstr;

/// The good case with an obstacle whose polygon is in a file.
struct PolygonObstacle {
  explicit PolygonObstacle(const std::string& lines, const std::string& keys = "")
      : text("source  =", "obstacle = [{ shape = { outline = \"o.csv\"" + keys + " } }]\nsource  =") {
    std::ofstream(std::filesystem::path(text.file()).parent_path() / "o.csv") << lines;
  }
  std::string errors() const { return errors_of(text.file()); }
  CaseText text;
};

struct Polygon {
  std::string name;
  std::string lines;
  std::string error;  // empty: it is good
  std::string keys = "";
};

const std::string key = "fluid.obstacle.0.shape: ";

const Polygon polygons[] = {
    {"Plain", "0.2,0\n0.26,0\n0.26,0.1\n0.2,0.1\n", ""},
    {"Clockwise", "0.2,0.1\n0.26,0.1\n0.26,0\n0.2,0\n", ""},
    {"FirstCornerAgainAtTheEnd", "0.2,0\n0.26,0\n0.26,0.1\n0.2,0.1\n0.2,0\n", ""},
    {"ACornerTwice", "0.2,0\n0.26,0\n0.26,0\n0.26,0.1\n0.2,0.1\n", ""},
    {"AHole",
     "0.2,0\n0.28,0\n0.28,0.1\n0.2,0.1\n0.2,0.05\n0.22,0.05\n0.22,0.08\n0.26,0.08\n0.26,0.05\n0.22,0.05\n"
     "0.2,0.05\n",
     ""},
    {"BelowTheFloor", "0.2,-0.04\n0.26,-0.04\n0.26,0.1\n0.2,0.1\n", ""},
    {"AboveTheTop", "0.2,0\n0.26,0\n0.26,0.4\n0.2,0.4\n", ""},
    {"InMillimetresAndScaled", "200,0\n260,0\n260,100\n200,100\n", "", ", scale = 0.001"},
    {"Turned", "0,-0.26\n0.1,-0.26\n0.1,-0.2\n0,-0.2\n", "", ", rotate = [90]"},
    {"Crossing", "0.2,0\n0.26,0.1\n0.26,0\n0.2,0.1\n", key + "the polygon crosses itself: the sides from"},
    {"Doubled", "0.2,0\n0.26,0\n0.26,0.1\n0.2,0.1\n0.2,0\n0.26,0\n0.26,0.1\n0.2,0.1\n",
     key + "the polygon overlaps itself"},
    {"TwoCorners", "0.2,0\n0.26,0\n", key + "the outline has 2 corners, needs at least 3"},
    {"OnALine", "0.2,0.1\n0.23,0.1\n0.26,0.1\n", key},
    {"ThinnerThanASpacing", "0.201,0\n0.204,0\n0.204,0.1\n0.201,0.1\n",
     key + "contains no particle with a spacing of 0.01 m: it is too thin"},
    {"InMillimetres", "200,0\n260,0\n260,100\n200,100\n", "; if its file is in mm, set scale = 0.001"},
    {"InMillimetresByItsHeader", "x [mm],y [mm]\n200,0\n260,0\n260,100\n",
     "o.csv:1: x is in mm, must be in m"},
    {"Beside", "0.4,0\n0.46,0\n0.46,0.1\n",
     key + "lies outside fluid.tank: it reaches from (0.4, 0) to (0.46, 0.1) m"},
    {"ThreeAnglesInAPlane", "0.2,0\n0.26,0\n0.26,0.1\n", "rotate has 3 angles, must have 1",
     ", rotate = [0, 0, 90]"},
};

class Polygons : public ::testing::TestWithParam<Polygon> {};

TEST_P(Polygons, AreTakenOrRefusedAsObstacles) {
  const std::string errors = PolygonObstacle(GetParam().lines, GetParam().keys).errors();
  if (GetParam().error.empty())
    EXPECT_EQ(errors, "");
  else
    EXPECT_THAT(errors, HasSubstr(GetParam().error));
}

INSTANTIATE_TEST_SUITE_P(RegionRules, Polygons, ::testing::ValuesIn(polygons),
                         [](const auto& polygon) { return polygon.param.name; });

TEST(RegionRules, ScaleRotateAndShiftAreForOutlines) {
  const CaseText text("{ min = [0.15, 0.0], max = [0.2, 0.2] }",
                      "{ min = [0.15, 0.0], max = [0.2, 0.2], shift = [0.1, 0.0] }");
  EXPECT_THAT(errors_of(text.file()), HasSubstr("scale, rotate and shift are for an outline only"));
}

TEST(RegionRules, WaterNeedsAParticleThatNothingElseTakes) {
  const CaseText text("source  =",
                      "obstacle = [{ shape = { min = [0.15, 0.0], max = [0.2, 0.2] } }]\nsource  =");
  EXPECT_THAT(errors_of(text.file()), HasSubstr("fluid.water.1: contains no water particle"));
}

TEST(RegionRules, AClampInTheTankNeedsAnObstacleAroundIt) {
  const CaseText text("clamp = [{ min = [0.1, -0.02], max = [0.14, 0.0] }]",
                      "clamp = [{ min = [0.1, 0.1], max = [0.14, 0.14] }]");
  EXPECT_THAT(errors_of(text.file()),
              HasSubstr("solid.body.0.clamp.0: lies in fluid.tank, where water would flow"));
  EXPECT_EQ(errors_of(text.file(), {"fluid.obstacle=[{ shape = { min = [0.1, 0.1], max = [0.14, 0.14] } }]",
                                    "output.probe.0.position=[0.1, 0.05]"}),
            "");
}

TEST(RegionRules, SizesAreEstimatedBeforeAnythingIsFilled) {
  // Each side is within 1e5 spacings, all of them together are not.
  const CaseText text;
  EXPECT_THAT(errors_of(text.file(), {"fluid.spacing=0.00001"}),
              HasSubstr("fluid.tank: has 9.01e+08 sites with fluid.spacing = 1e-05 m, must be < 1e+08"));
  const std::string cantilever = std::string(COSURGE_SOURCE_DIR) + "/cases/cantilever/case.toml";
  EXPECT_THAT(errors_of(cantilever, {"solid.spacing=0.000001"}), HasSubstr("solid."));
}

TEST(RegionRules, ACoordinateThatIsTooFarIsNamed) {
  const CaseText text;
  EXPECT_THAT(
      errors_of(text.file(), {"fluid.spacing=0.000001"}),
      HasSubstr("fluid.spacing: 1e-06 must be >= 3e-06 [m]: the coordinate 0.3 of fluid.tank is 3e+05 "
                "spacings, at most 100000 are possible"));
}

TEST(RegionRules, WhatDoesNotFitTheLatticeMayBeRounded) {
  const CaseText text("max = [0.3, 0.3] }", "max = [0.303, 0.3] }");
  EXPECT_THAT(errors_of(text.file()), HasSubstr("; or round 0.303 to 0.3, or give the shape as an outline"));
}

}  // namespace
}  // namespace cosurge
