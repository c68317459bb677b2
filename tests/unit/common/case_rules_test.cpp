#include "common/case/case_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/case_text.hpp"

namespace cosurge {
namespace {

using testing::CaseText;
using testing::errors_of;
using ::testing::HasSubstr;
using testing::line_of;
using ::testing::StartsWith;

/// A line of the valid case, its replacement, and the one error that must follow. `place` is a
/// piece of the line that the error names; empty for the spoiled line itself.
struct Spoiled {
  std::string name;
  std::string from;
  std::string to;
  std::string error;
  std::string place = "";
};

const Spoiled table[] = {
    // Keys
    {"UnknownKeyAtTheTop",
     "gravity =", "wind = 3\ngravity =", "wind: unknown key, allowed: title, reference, dimension"},
    {"UnknownTable", "[coupling]", "[couplings]", "couplings: unknown key"},
    {"UnknownKeyInATable", "end    = 0.1", "end = 0.1\nstop = 1",
     "time.stop: unknown key, allowed: end, window, stepping", "stop = 1"},
    {"UnknownKeyInABox", "tank    = { min", "tank    = { low = 1, min",
     "fluid.tank.low: unknown key, allowed: min, max"},
    {"UnknownKeyInAListEntry", "name = \"P1\"", "name = \"P1\"\nunit = \"Pa\"",
     "output.probe.1.unit: unknown key", "unit ="},
    {"UnknownKeyInASubtable", "{ max_iterations = 500 }", "{ max_iteration = 500 }",
     "fluid.pressure.max_iteration: unknown key"},
    {"MissingText", "title   = \"Plate in water\"\n", "", "title: missing", "gravity"},
    {"MissingNumber", "density       = 2500.0\n", "", "solid.density: missing", "[solid]"},
    {"MissingVector", "gravity = [0.0, -9.81]\n", "", "gravity: missing", "title"},
    {"MissingTable", "tank    = { min = [0.0, 0.0], max = [0.3, 0.3] }\n", "", "fluid.tank: missing",
     "[fluid]"},
    {"MissingCorner", "tank    = { min = [0.0, 0.0], ", "tank    = { ", "fluid.tank.min: missing"},
    // Types
    {"TextForANumber", "end    = 0.1", "end = \"late\"", "time.end: must be a number"},
    {"NumberForAText", "title   = \"Plate in water\"", "title = 3", "title: must be a text in quotes"},
    {"FractionForAWholeNumber", "max_iterations = 500", "max_iterations = 500.5",
     "fluid.pressure.max_iterations: must be a whole number"},
    {"WholeNumberBeyondAllBounds", "max_iterations = 500", "max_iterations = 5000000000",
     "fluid.pressure.max_iterations: 5000000000 must be <= 2147483647"},
    {"NumberForATable", "tank    = { min = [0.0, 0.0], max = [0.3, 0.3] }", "tank = 3",
     "fluid.tank: must be a table, allowed keys: min, max"},
    {"TableForAList", "clamp = [{ min = [0.1, -0.02], max = [0.14, 0.0] }]",
     "clamp = { min = [0.1, -0.02], max = [0.14, 0.0] }", "solid.body.0.clamp: must be a list of tables"},
    {"NumberForAVector", "position = [0.1, 0.05]", "position = 0.1",
     "output.probe.1.position: must be a list"},
    {"TextInAVector", "position = [0.1, 0.05]", "position = [0.1, \"low\"]",
     "output.probe.1.position.1: must be a number"},
    {"NumberInAListOfTables", "clamp = [{ min = [0.1, -0.02], max = [0.14, 0.0] }]", "clamp = [1]",
     "solid.body.0.clamp.0: must be a table"},
    {"UnknownWord", "source  = \"mixed\"", "source = \"mix\"",
     "fluid.source: must be one of: deviation, mixed, time_scale"},
    {"NumberForAWord", "source  = \"mixed\"", "source = 1", "fluid.source: must be one of: deviation"},
    // Ranges
    {"Negative", "spacing = 0.01", "spacing = -0.01", "fluid.spacing: -0.01 must be > 0 [m]"},
    {"Zero", "density       = 2500.0", "density = 0", "solid.density: 0 must be > 0 [kg/m3]"},
    {"AboveTheBound", "young_modulus = 1.0e6", "young_modulus = 1.0e6\npoisson_ratio = 0.5",
     "solid.poisson_ratio: 0.5 must be < 0.5 [-]", "poisson_ratio"},
    {"Infinite", "young_modulus = 1.0e6", "young_modulus = inf",
     "solid.young_modulus: inf must be finite [Pa]"},
    {"NotANumber", "end    = 0.1", "end = nan", "time.end: nan must be finite [s]"},
    {"NotANumberInAVector", "gravity = [0.0, -9.81]", "gravity = [nan, 0.0]",
     "gravity.0: nan must be finite [m/s2]"},
    {"FourDimensions", "gravity =", "dimension = 4\ngravity =", "dimension: 4 must be <= 3"},
    // Lengths
    {"VectorTooLong", "position = [0.1, 0.05]", "position = [0.1, 0.05, 0.0]",
     "output.probe.1.position: has 3 components, must have 2"},
    {"VectorTooShort", "gravity = [0.0, -9.81]", "gravity = [0.0]", "gravity: has 1 components, must have 2"},
    {"ListTooShort",
     "water   = [{ min = [0.0, 0.0], max = [0.1, 0.2] }, { min = [0.15, 0.0], max = [0.2, 0.2] }]",
     "water = []", "fluid.water: has 0 entries, needs at least 1"},
    // Boxes
    {"InvertedBox", "max = [0.2, 0.2] }]", "max = [0.12, 0.2] }]",
     "fluid.water.1: min 0.15 must be < max 0.12 in coordinate 0"},
    {"EmptyBox", "max = [0.2, 0.2] }]", "max = [0.2, 0.0] }]",
     "fluid.water.1: min 0 must be < max 0 in coordinate 1"},
    {"OverlappingWater", "{ min = [0.15, 0.0], max = [0.2, 0.2] }",
     "{ min = [0.05, 0.1], max = [0.1, 0.25] }", "fluid.water.1: overlaps fluid.water.0"},
    {"WaterInABody", "{ min = [0.15, 0.0], max", "{ min = [0.13, 0.0], max",
     "fluid.water.1: overlaps solid.body.0.box"},
    {"WaterOutsideTheTank", "max = [0.2, 0.2] }]", "max = [0.31, 0.2] }]",
     "fluid.water.1: must lie inside fluid.tank"},
    {"BodyOutsideTheTank", "max = [0.14, 0.1] }", "max = [0.14, 0.31] }",
     "solid.body.0.box: must lie inside fluid.tank"},
    {"InvertedClamp", "clamp = [{ min = [0.1, -0.02]", "clamp = [{ min = [0.1, 0.02]",
     "solid.body.0.clamp.0: min 0.02 must be < max 0 in coordinate 1"},
    {"ClampOffTheBody", "clamp = [{ min = [0.1, -0.02], max = [0.14, 0.0] }]",
     "clamp = [{ min = [0.1, -0.05], max = [0.14, -0.02] }]", "solid.body.0.clamp.0: must touch the body"},
    {"ThinBody", "max = [0.14, 0.1] }", "max = [0.12, 0.1] }",
     "solid.body.0.box: is 2 spacings thick, must be at least 3: a spacing of 0.006667 m at most, or a "
     "thicker body"},
    {"SpacingThatDoesNotDivide", "spacing = 0.01", "spacing = 0.012",
     "the nearest values that divide every box are 0.01 below and none above"},
    {"BoxOffTheLattice", "max = [0.3, 0.3] }", "max = [0.303, 0.3] }",
     "does not divide fluid.tank (0.303 is 30.3 spacings)", "spacing"},
    {"SolidSpacingThatDoesNotDivide", "density       = 2500.0", "density = 2500.0\nspacing = 0.003",
     "solid.spacing: 0.003 does not divide solid.body.0.box", "spacing = 0.003"},
    // Between keys
    {"WideLaplacian", "source  =", "re_gradient = 1.6\nsource  =",
     "fluid.re_laplacian: 4 must be <= 2 fluid.re_gradient", "[fluid]"},
    {"ProbeOutsideItsBody", "position = [0.1, 0.1]", "position = [0.2, 0.05]",
     "output.probe.0.position: must lie in or on a body; solid.body.0 is 0.06 m away, at (0.14, 0.05)"},
    {"LevelOutsideTheTank", "quantity = \"pressure\"\nposition = [0.1, 0.05]",
     "quantity = \"level\"\nposition = [0.4, 0.05]",
     "output.probe.1.position: must lie in fluid.tank or on a body", "position = [0.4"},
    {"ForceOffEveryBody", "quantity = \"pressure\"\nposition = [0.1, 0.05]",
     "quantity = \"force\"\nposition = [0.2, 0.05]",
     "output.probe.1.position: must lie in or on a body or an obstacle, or on the floor or a side wall of "
     "fluid.tank; solid.body.0 is 0.06 m away, at (0.14, 0.05)",
     "position = [0.2"},
    {"MomentInTheWater", "quantity = \"pressure\"\nposition = [0.1, 0.05]",
     "quantity = \"moment\"\nposition = [0.2, 0.05]",
     "output.probe.1.position: must lie in or on a body or an obstacle", "position = [0.2"},
    {"PressureDeepInABody", "position = [0.1, 0.05]", "position = [0.118, 0.05]",
     "output.probe.1.position: lies 0.018 m inside a body: pressure is measured on its surface, whose "
     "nearest point is (0.1, 0.05)"},
    {"ShapeThatIsNothing", "{ min = [0.15, 0.0], max = [0.2, 0.2] }", "{ min = [0.15, 0.0] }",
     "fluid.water.1: must have either min and max, or outline", "water   ="},
    {"ThinObstacle",
     "source  =", "obstacle = [{ shape = { min = [0.2, 0.0], max = [0.22, 0.1] } }]\nsource  =",
     "fluid.obstacle.0.shape: is 2 spacings thick, must be at least 4"},
    {"MotionWithoutAFrequency", "source  =", "tank_motion = { amplitude = [0.1, 0.0] }\nsource  =",
     "fluid.tank_motion.frequency: must be > 0 [Hz] if there is an amplitude"},
    {"ProbeNameTwice", "name = \"P1\"", "name   = \"tip\"", "output.probe.1.name: \"tip\" is taken"},
    {"ProbeNameOfTheWatersOwn", "name = \"P1\"", "name = \"max_speed\"",
     "output.probe.1.name: \"max_speed\" needs the column max_speed, which the fluid solver already writes"},
    {"ProbeNameLikePhases", "name = \"P1\"", "name = \"seconds_total\"",
     "output.probe.1.name: \"seconds_total\" needs the column seconds_total, which"},
    {"ProbeNameThatADirectionHas", "name = \"P1\"", "name = \"tip_x\"",
     "output.probe.1.name: \"tip_x\" needs the column tip_x, which output.probe.0 (\"tip\") needs too"},
    {"ProbeNameWithASpace", "name = \"P1\"", "name = \"P 1\"",
     "output.probe.1.name: must consist of letters"},
    {"ProbeWithoutAName", "name = \"P1\"", "name = \"\"", "output.probe.1.name: must consist of letters"},
    {"WindowBeyondTheEnd", "window = 1.0e-3", "window = 0.2", "time.window: 0.2 must be <= time.end = 0.1"},
    {"FramesCloserThanWindows", "frame_interval = 0.01", "frame_interval = 0.0005",
     "output.frame_interval: 0.0005 must be >= time.window = 0.001"},
    {"FixedWindowsThatDoNotDivideTheEnd", "window = 1.0e-3", "window = 0.003\nstepping = \"fixed\"",
     "time.end: 0.1 must be a whole number of windows of 0.003", "end    ="},
    {"FixedWindowsWithoutASize", "window = 1.0e-3", "stepping = \"fixed\"",
     "time.window: missing, fixed windows need it", "[time]"},
};

class SpoiledCase : public ::testing::TestWithParam<Spoiled> {};

TEST_P(SpoiledCase, IsRefusedWithItsKeyAndItsLine) {
  const Spoiled& s = GetParam();
  const CaseText text(s.from, s.to);
  const std::string errors = errors_of(text.file());
  EXPECT_THAT(errors, HasSubstr(s.error));
  const std::string where = s.place.empty() ? s.to.substr(0, s.to.find('\n')) : s.place;
  // The line with the error begins with its place.
  const auto at = errors.find(s.error);
  if (at == std::string::npos) return;
  const auto begin = errors.rfind('\n', at);
  const std::string line = errors.substr(begin == std::string::npos ? 0 : begin + 1);
  EXPECT_THAT(line, StartsWith(fmt::format("{}:{}: ", text.file(), line_of(text, where))));
}

INSTANTIATE_TEST_SUITE_P(CaseRules, SpoiledCase, ::testing::ValuesIn(table),
                         [](const auto& spoiled) { return spoiled.param.name; });

TEST(CaseRules, ProbesMayHaveNamesThatOnlyTheOtherSolverHas) {
  const CaseText text;
  for (const char* name : {"front", "kinetic_energy", "lost_x_min"})
    EXPECT_EQ(errors_of(text.file(), {fmt::format("output.probe.0.name={}", name)}), "") << name;
  EXPECT_EQ(errors_of(text.file(), {"output.probe.1.name=elastic_energy"}), "");
  // A force "load" makes load_x and load_y; so does a pressure of that name.
  const std::vector<std::string> two = {
      "output.probe=[{ name = \"load\", quantity = \"force\", position = [0.12, 0.05] }, "
      "{ name = \"load_y\", quantity = \"pressure\", position = [0.1, 0.05] }]"};
  EXPECT_THAT(errors_of(text.file(), two),
              HasSubstr("needs the column load_y, which output.probe.0 (\"load\")"));
}

TEST(CaseRules, ProbesOffABodyByARoundingAreMovedOntoIt) {
  const CaseText text;
  const v1::Case c = load_case(
      text.file(), {"output.probe.0.position=[0.14003, 0.05]", "output.probe.1.position=[0.0999999, 0.05]"});
  EXPECT_EQ(c.output().probe(0).position(0), 0.14);
  EXPECT_EQ(c.output().probe(1).position(0), 0.1);
  // Pressure farther off is the water's.
  EXPECT_EQ(load_case(text.file(), {"output.probe.1.position=[0.097, 0.05]"}).output().probe(1).position(0),
            0.097);
}

TEST(CaseRules, TheGoodCaseOfTheTableIsGood) { EXPECT_EQ(errors_of(CaseText().file()), ""); }

TEST(CaseRules, FixedWindowsMustDivideTheEndAndTheFrames) {
  const CaseText text;
  const std::string errors = errors_of(text.file(), {"time.stepping=fixed", "time.window=0.0007"});
  EXPECT_THAT(errors, HasSubstr("time.end: 0.1 must be a whole number of windows of 0.0007"));
  EXPECT_THAT(errors, HasSubstr("output.frame_interval: 0.01 must be a whole number of windows of 0.0007"));
  EXPECT_EQ(errors_of(text.file(), {"time.stepping=fixed", "time.window=0.0005"}), "");
}

const std::string hydrostatic = std::string(COSURGE_SOURCE_DIR) + "/cases/hydrostatic/case.toml";
const std::string cantilever = std::string(COSURGE_SOURCE_DIR) + "/cases/cantilever/case.toml";

TEST(CaseRules, CouplingNeedsBothAFluidAndASolid) {
  for (const std::string& file : {hydrostatic, cantilever})
    EXPECT_THAT(errors_of(file, {"coupling.scheme=weak"}),
                HasSubstr("coupling: allowed only if the case has a [fluid] and a [solid]"));
}

TEST(CaseRules, AddedMassNeedsWaterThatAnswersVelocities) {
  const CaseText text;
  for (const std::string scheme : {"weak_inertial", "strong_inertial"}) {
    const std::string word = "coupling.scheme=" + scheme;
    EXPECT_THAT(errors_of(text.file(), {word, "fluid.source=deviation"}),
                HasSubstr("coupling.scheme: " + scheme + " needs a source with the velocity divergence"));
    EXPECT_EQ(errors_of(text.file(), {word}), "");
  }
}

TEST(CaseRules, WithoutGravityATimeScaleNeedsItsSpeed) {
  const CaseText text;
  const std::vector<std::string> words = {"gravity=[0, 0]", "fluid.source=time_scale"};
  EXPECT_THAT(errors_of(text.file(), words), HasSubstr("fluid.propagation_speed: missing"));
  EXPECT_EQ(errors_of(text.file(), {words[0], words[1], "fluid.propagation_speed=1"}), "");
  EXPECT_EQ(errors_of(text.file(), {words[1]}), "");
}

TEST(CaseRules, ASceneNeedsSomethingInIt) {
  const CaseText text(std::string(testing::good_case),
                      "title = \"Nothing\"\ngravity = [0, 0]\n[time]\nend = 1\nwindow = 1\n");
  EXPECT_THAT(errors_of(text.file()), HasSubstr("a case needs a [fluid], a [solid], or both"));
}

TEST(CaseRules, ASolidAloneNeedsItsSpacing) {
  const CaseText text(
      std::string(testing::good_case),
      "title = \"Plate\"\ngravity = [0, 0]\n[time]\nend = 1\nwindow = 0.01\n[solid]\ndensity = 1\n"
      "young_modulus = 1\n[[solid.body]]\nbox = { min = [0, 0], max = [1, 1] }\n");
  EXPECT_THAT(errors_of(text.file()),
              HasSubstr("solid.spacing: missing (there is no fluid to take it from)"));
}

TEST(CaseRules, PressureProbesNeedWater) {
  EXPECT_THAT(errors_of(cantilever, {"output.probe.0.quantity=pressure"}),
              HasSubstr("output.probe.0.quantity: needs a fluid"));
}

TEST(CaseRules, DisplacementProbesBesideABodyAreRefusedWithoutWaterToo) {
  EXPECT_THAT(errors_of(cantilever, {"output.probe.0.position=[0.1, 0.05]"}),
              HasSubstr("output.probe.0.position: must lie in or on a body; solid.body.0 is 0.088 m away, at "
                        "(0.012, 0.05)"));
}

TEST(CaseRules, ABodyIsThickEnoughThatTheLaplacianDoesNotSeeThroughIt) {
  const CaseText text("max = [0.14, 0.1] }", "max = [0.13, 0.1] }");
  const std::vector<std::string> narrow_clamp = {"solid.body.0.clamp.0.max=[0.13, 0.0]"};
  EXPECT_EQ(errors_of(text.file(), narrow_clamp), "");
  EXPECT_THAT(errors_of(text.file(), {narrow_clamp[0], "fluid.re_laplacian=5", "fluid.re_gradient=2.5"}),
              HasSubstr("solid.body.0.box: is 3 spacings thick, must be at least 4"));
}

TEST(CaseRules, SpacingsThatDivideInDecimalsAreAccepted) {
  // 0.146 / 0.002 and 0.3 / 0.1 are no whole numbers in binary.
  for (const char* spacing : {"0.001", "0.002", "0.005", "0.01"})
    EXPECT_EQ(errors_of(CaseText().file(), {fmt::format("fluid.spacing={}", spacing)}), "") << spacing;
}

TEST(CaseRules, SpacingsOfAnySizeAreAnswered) {
  for (const char* spacing : {"1e-300", "1e-12", "3.3333e-9", "7", "1e300"}) {
    const std::string errors = errors_of(CaseText().file(), {fmt::format("fluid.spacing={}", spacing)});
    EXPECT_THAT(errors, HasSubstr("fluid.spacing")) << spacing;
  }
}

TEST(CaseRules, WhatHoldsABodyMovesInOneWay) {
  const std::string motion = "solid.body.0.motion={ amplitude = [0.01, 0.0], frequency = 2.0 }";
  EXPECT_EQ(errors_of(CaseText().file(), {motion}), "");
  EXPECT_THAT(errors_of(CaseText().file(), {"solid.body.0.motion={ amplitude = [0.01, 0.0] }"}),
              HasSubstr("solid.body.0.motion.frequency: must be > 0"));
  EXPECT_THAT(errors_of(CaseText().file(), {motion, "solid.body.0.clamp=[]"}),
              HasSubstr("solid.body.0.motion: is the motion of what holds the body, but nothing holds it"));
}

TEST(CaseRules, OnlyABodyThatCanHaveItMayStartWithAVelocity) {
  const std::string velocity = "solid.body.0.velocity=[0.0, -2.0]";
  EXPECT_THAT(errors_of(CaseText().file(), {velocity}),
              HasSubstr("solid.body.0.velocity: is the initial velocity of a free body"));
  EXPECT_EQ(errors_of(CaseText().file(), {velocity, "solid.body.0.clamp=[]"}), "");
  const std::vector<std::string> on_springs = {velocity, "solid.body.0.clamp=[]", "solid.model=sprung"};
  const auto with = [&](const std::string& spring) {
    std::vector<std::string> all = on_springs;
    all.push_back(spring);
    return errors_of(CaseText().file(), all);
  };
  EXPECT_THAT(with("solid.sprung.spring=[{ motion = \"x\" }]"), HasSubstr("the body is fixed along y"));
  EXPECT_EQ(with("solid.sprung.spring=[{ motion = \"y\" }]"), "");
}

TEST(CaseErrors, ArePlacedAtTheNearestKeyThatStandsInTheFile) {
  CaseErrors errors;
  errors.places = {{"", "case.toml"}, {"fluid", "case.toml:3"}};
  EXPECT_NO_THROW(errors.raise());
  errors.add("fluid.tank.min", "is wrong");
  errors.add("solid", "is missing");
  EXPECT_EQ(errors.lines[0], "case.toml:3: fluid.tank.min: is wrong");
  EXPECT_EQ(errors.lines[1], "case.toml: solid: is missing");
  EXPECT_THROW(errors.raise(), Error);
}

}  // namespace
}  // namespace cosurge
