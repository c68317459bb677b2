// Rules for bodies whose shape is an outline.
#include "common/case/outline_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/case_text.hpp"
#include "tests/support/outlines.hpp"

namespace cosurge {
namespace {

using testing::CaseText;
using ::testing::EndsWith;
using testing::errors_of;
using ::testing::HasSubstr;

/// The good case with a body from a file of these lines.
struct OutlinedBody {
  explicit OutlinedBody(const std::string& lines, const std::string& file = "shape.csv")
      : text("box   = { min = [0.1, 0.0], max = [0.14, 0.1] }", "shape = { outline = \"" + file + "\" }") {
    std::ofstream(std::filesystem::path(text.file()).parent_path() / file) << lines;
  }
  std::string errors(const std::vector<std::string>& overrides = {}) const {
    return errors_of(text.file(), overrides);
  }
  CaseText text;
};

const std::string plate = "0.1, 0\n0.14, 0\n0.14, 0.1\n0.1, 0.1\n";

TEST(OutlinedBodies, AreReadWithWhatOnesTheyClampTo) {
  const OutlinedBody body(plate);
  const v1::Case c = load_case(body.text.file());
  EXPECT_FALSE(c.solid().body(0).has_box());
  EXPECT_EQ(c.solid().body(0).shape().vertex_size(), 8);
  // Clamps are shapes, too.
  const OutlinedBody clamped(plate);
  std::ofstream(std::filesystem::path(clamped.text.file()).parent_path() / "foot.csv")
      << "0.1, -0.02\n0.14, -0.02\n0.14, 0\n0.1, 0\n";
  EXPECT_EQ(clamped.errors({"solid.body.0.clamp=[{ outline = \"foot.csv\" }]"}), "");
}

TEST(OutlinedBodies, NeedEitherABoxOrAShape) {
  const CaseText both("clamp = [{", "shape = { outline = \"shape.csv\" }\nclamp = [{");
  std::ofstream(std::filesystem::path(both.file()).parent_path() / "shape.csv") << plate;
  EXPECT_THAT(errors_of(both.file()), HasSubstr("solid.body.0: must have either box or shape"));
  const CaseText none("box   = { min = [0.1, 0.0], max = [0.14, 0.1] }\n", "");
  EXPECT_THAT(errors_of(none.file()), HasSubstr("solid.body.0: must have either box or shape"));
}

TEST(OutlinedBodies, StandWhereTheirOutlineIsNamed) {
  const OutlinedBody body("0.1, 0\n0.14, 0\n");
  EXPECT_EQ(body.errors(),
            fmt::format("{}:{}: solid.body.0.shape: the outline has 2 corners, needs at least 3",
                        body.text.file(), testing::line_of(body.text, "shape =")));
}

TEST(OutlinedBodies, OfTheWrongDimensionAreRefused) {
  EXPECT_THAT(OutlinedBody("solid\n", "shape.stl").errors(),
              HasSubstr("a scene of two dimensions needs a polygon, with one corner x, y per line"));
  const testing::ScratchFolder folder;
  std::ofstream(folder.path() / "shape.csv") << plate;
  std::ofstream(folder.path() / "case.toml") << R"(title = "Polygon in space"
dimension = 3
gravity = [0, 0, 0]
time = { end = 0.1, window = 1e-3 }
solid = { spacing = 0.01, density = 1, young_modulus = 1, body = [{ shape = { outline = "shape.csv" } }] }
)";
  EXPECT_THAT(errors_of(folder.path().string()), HasSubstr("a scene of three dimensions needs an STL file"));
}

TEST(OutlinedBodies, MustEncloseParticlesInOnePieceInsideTheTank) {
  EXPECT_THAT(OutlinedBody("0.1, 0\n0.14, 0\n0.12, 0.008\n").errors(),
              HasSubstr("solid.body.0.shape: is 0.8 spacings thick, must be at least 3"));
  EXPECT_THAT(OutlinedBody("0.1, 0\n0.101, 0\n0.14, 0.1\n0.139, 0.1\n").errors(),
              HasSubstr("solid.body.0.shape: encloses no particles with a spacing of 0.01 m"));
  EXPECT_THAT(OutlinedBody("0.1, 0\n0.14, 0\n0.121, 0.05\n0.14, 0.1\n0.1, 0.1\n0.119, 0.05\n").errors(),
              HasSubstr("solid.body.0.shape: consists of 2 separate parts with a spacing of 0.01 m"));
  EXPECT_THAT(OutlinedBody("0.1, 0\n0.14, 0\n0.14, 0.1\n0.1, 0.31\n").errors(),
              HasSubstr("solid.body.0.shape: must lie inside fluid.tank"));
}

TEST(OutlinedBodies, InMillimetresAreToldSo) {
  EXPECT_THAT(OutlinedBody("100, 0\n140, 0\n140, 100\n100, 100\n").errors(),
              HasSubstr("solid.body.0.shape: must lie inside fluid.tank; it reaches from (100, 0) to (140, "
                        "100) m; if its file is in mm, set scale = 0.001"));
  const CaseText scaled("box   = { min = [0.1, 0.0], max = [0.14, 0.1] }",
                        "shape = { outline = \"shape.csv\", scale = 0.001 }");
  std::ofstream(std::filesystem::path(scaled.file()).parent_path() / "shape.csv")
      << "100, 0\n140, 0\n140, 100\n100, 100\n";
  EXPECT_EQ(errors_of(scaled.file()), "");
}

TEST(OutlinedBodies, MustNotOverlapEachOther) {
  const OutlinedBody body(plate);
  const auto beside = [&](const char* min, const char* max) {
    return body.errors({fmt::format("solid.body=[{{ shape = {{ outline = \"shape.csv\" }} }}, "
                                    "{{ box = {{ min = {}, max = {} }} }}]",
                                    min, max),
                        "fluid.water=[{ min = [0.0, 0.0], max = [0.1, 0.2] }]"});
  };
  EXPECT_EQ(beside("[0.14, 0.0]", "[0.2, 0.1]"), "");
  EXPECT_THAT(beside("[0.13, 0.0]", "[0.2, 0.1]"), EndsWith("solid.body.0.shape: overlaps solid.body.1.box"));
}

TEST(OutlinedBodies, MustNotOverlapAnotherOutline) {
  const OutlinedBody body(plate);
  std::ofstream(std::filesystem::path(body.text.file()).parent_path() / "beside.csv")
      << "0.13, 0\n0.2, 0\n0.2, 0.1\n0.13, 0.1\n";
  EXPECT_THAT(body.errors({"solid.body=[{ shape = { outline = \"shape.csv\" } }, "
                           "{ shape = { outline = \"beside.csv\" } }]",
                           "fluid.water=[{ min = [0.0, 0.0], max = [0.1, 0.2] }]"}),
              HasSubstr("solid.body.1.shape: overlaps solid.body.0.shape"));
}

TEST(Bodies, MustNotOverlapObstaclesWhateverTheirShapes) {
  const auto box = [](const char* min, const char* max) {
    return fmt::format("fluid.obstacle=[{{ shape = {{ min = {}, max = {} }} }}]", min, max);
  };
  const OutlinedBody outlined(plate);
  const std::string dry = "fluid.water=[{ min = [0.0, 0.0], max = [0.1, 0.2] }]";
  EXPECT_EQ(outlined.errors({box("[0.14, 0.0]", "[0.22, 0.1]"), dry}), "");  // touches
  EXPECT_EQ(outlined.errors({box("[0.13, 0.0]", "[0.22, 0.1]"), dry}),
            fmt::format("{}:{}: solid.body.0.shape: overlaps fluid.obstacle.0.shape", outlined.text.file(),
                        testing::line_of(outlined.text, "shape =")));
  const CaseText boxed;
  EXPECT_EQ(errors_of(boxed.file(), {box("[0.06, 0.0]", "[0.11, 0.1]")}),
            fmt::format("{}:{}: solid.body.0.box: overlaps fluid.obstacle.0.shape", boxed.file(),
                        testing::line_of(boxed, "box   =")));
  // A triangle of an obstacle beside the box, and one into it.
  for (const bool into : {false, true}) {
    std::ofstream(std::filesystem::path(boxed.file()).parent_path() / "ramp.csv")
        << (into ? "0.12, 0\n0.25, 0\n0.25, 0.1\n" : "0.14, 0\n0.25, 0\n0.25, 0.1\n");
    const std::string errors =
        errors_of(boxed.file(), {"fluid.obstacle=[{ shape = { outline = \"ramp.csv\" } }]"});
    EXPECT_EQ(errors.empty(), !into) << errors;
  }
}

TEST(OutlinedBodies, WaterGivesWayToThem) {
  // A box would be refused there.
  EXPECT_EQ(OutlinedBody(plate).errors({"fluid.water=[{ min = [0.0, 0.0], max = [0.2, 0.2] }]"}), "");
}

TEST(OutlinedBodies, MustNotCrossThemselves) {
  EXPECT_THAT(OutlinedBody("0.1, 0\n0.14, 0.1\n0.14, 0\n0.1, 0.1\n").errors(),
              HasSubstr("the polygon crosses itself: the sides from corners 0 and 2"));
}

TEST(OutlinedBodies, ProbesLieInOrOnThem) {
  const OutlinedBody body("0.1, 0\n0.14, 0\n0.1, 0.1\n");
  EXPECT_EQ(body.errors({"output.probe.0.position=[0.12, 0.05]"}), "");
  EXPECT_THAT(body.errors({"output.probe.0.position=[0.121, 0.05]"}),
              HasSubstr("output.probe.0.position: must lie in or on a body"));
}

TEST(OutlinedBodies, OfAnySpacingAreAnswered) {
  const testing::ScratchFolder folder;
  std::ofstream(folder.path() / "shape.csv") << plate;
  std::ofstream(folder.path() / "case.toml") << R"(title = "Plate"
gravity = [0, 0]
time = { end = 0.1, window = 1e-3 }
solid = { spacing = 0.01, density = 1, young_modulus = 1, body = [{ shape = { outline = "shape.csv" } }] }
)";
  EXPECT_EQ(errors_of(folder.path().string()), "");
  for (const char* spacing : {"1e-300", "1e-9", "7", "1e300"})
    EXPECT_THAT(errors_of(folder.path().string(), {fmt::format("solid.spacing={}", spacing)}),
                HasSubstr("solid."))
        << spacing;
}

TEST(NotClosed, KnowsTrianglesWithAHoleOrTheWrongWayAround) {
  v1::Shape shape = test::tetrahedron(1, {0, 0, 0});
  EXPECT_EQ(not_closed(shape, 3), "");
  EXPECT_EQ(not_closed(test::prism(1, 1, 1), 3), "");
  v1::Shape turned = shape;
  for (int axis = 0; axis < 3; ++axis) {
    turned.set_vertex(3 + axis, shape.vertex(6 + axis));
    turned.set_vertex(6 + axis, shape.vertex(3 + axis));
  }
  EXPECT_THAT(not_closed(turned, 3), HasSubstr("have opposite orientations, at the edge from (0, 0, 0)"));
  shape.mutable_vertex()->Truncate(27);
  EXPECT_THAT(not_closed(shape, 3), HasSubstr("leave a hole"));
}

}  // namespace
}  // namespace cosurge
