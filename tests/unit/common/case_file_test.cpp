#include "common/case/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "common/error.hpp"
#include "tests/support/case_text.hpp"

namespace cosurge {
namespace {

using testing::CaseText;
using testing::errors_of;
using ::testing::HasSubstr;
using testing::line_of;
using ::testing::Not;

TEST(CaseFile, EveryCaseOfTheProjectLoads) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(COSURGE_SOURCE_DIR) / "cases")) {
    if (!std::filesystem::exists(entry.path() / "case.toml")) continue;
    EXPECT_NO_THROW(load_case(entry.path().string())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 4);
}

TEST(CaseFile, AFolderAndItsFileAreTheSameCase) {
  const CaseText text;
  const v1::Case by_file = load_case(text.file());
  const v1::Case by_folder = load_case(std::filesystem::path(text.file()).parent_path().string());
  EXPECT_EQ(by_file.SerializeAsString(), by_folder.SerializeAsString());
}

TEST(CaseFile, ValuesArriveInTheMessage) {
  const v1::Case c = load_case(CaseText().file());
  EXPECT_EQ(c.title(), "Plate in water");
  EXPECT_EQ(c.gravity(1), -9.81);
  EXPECT_EQ(c.time().end(), 0.1);
  EXPECT_EQ(c.fluid().water(1).max(0), 0.2);
  EXPECT_EQ(c.fluid().source(), v1::Fluid::mixed);
  EXPECT_EQ(c.fluid().pressure().max_iterations(), 500);
  EXPECT_EQ(c.solid().body(0).clamp(0).min(1), -0.02);
  EXPECT_EQ(c.output().probe(1).quantity(), v1::Probe::pressure);
  EXPECT_FALSE(c.solid().has_spacing());  // no default: absent means the fluid's
}

TEST(CaseFile, DefaultsAreWrittenIntoTheMessage) {
  const v1::Case c = load_case(CaseText().file());
  EXPECT_TRUE(c.has_dimension());
  EXPECT_TRUE(c.time().has_stepping());
  EXPECT_TRUE(c.fluid().has_density());
  EXPECT_EQ(c.fluid().density(), 1000);
  EXPECT_TRUE(c.fluid().has_free_surface());
  EXPECT_TRUE(c.fluid().free_surface().has_beta());
  EXPECT_TRUE(c.fluid().pressure().has_preconditioner());
  EXPECT_TRUE(c.solid().mps().has_re());
  EXPECT_TRUE(c.has_coupling());
  EXPECT_TRUE(c.coupling().has_scheme());
  EXPECT_TRUE(c.output().has_frame_interval());
}

TEST(CaseFile, WhatTheSceneDoesNotHaveIsNotMadeUp) {
  const v1::Case c = load_case(std::string(COSURGE_SOURCE_DIR) + "/cases/hydrostatic");
  EXPECT_FALSE(c.has_solid());
  EXPECT_FALSE(c.has_coupling());
  EXPECT_TRUE(c.has_output());
}

TEST(CaseFile, OverridesAreAppliedBeforeTheChecks) {
  const CaseText text;
  const v1::Case c =
      load_case(text.file(), {"time.end=0.2", "fluid.source=time_scale", "output.probe.0.name=top",
                              "coupling.load=\"ramped\"", "gravity=[0, -1.62]", "gravity.0=0.5",
                              "solid.mps.re=3.1", "title=on the moon"});
  EXPECT_EQ(c.time().end(), 0.2);
  EXPECT_EQ(c.fluid().source(), v1::Fluid::time_scale);
  EXPECT_EQ(c.output().probe(0).name(), "top");
  EXPECT_EQ(c.coupling().load(), v1::Coupling::ramped);
  EXPECT_EQ(c.gravity(0), 0.5);
  EXPECT_EQ(c.gravity(1), -1.62);
  EXPECT_EQ(c.solid().mps().re(), 3.1);
  EXPECT_EQ(c.title(), "on the moon");
}

TEST(CaseFile, TheWordNoneRemovesAKeySoThatItsDefaultHolds) {
  const CaseText text;
  EXPECT_TRUE(load_case(text.file()).time().has_window());
  EXPECT_FALSE(load_case(text.file(), {"time.window=none"}).time().has_window());
  EXPECT_EQ(load_case(text.file(), {"fluid.source=none"}).fluid().source(), v1::Fluid::time_scale);
  EXPECT_EQ(load_case(text.file(), {"title=\"none\""}).title(), "none");
  EXPECT_THAT(errors_of(text.file(), {"time.end=none"}), HasSubstr("time.end: missing"));
  EXPECT_THAT(errors_of(text.file(), {"output.probe.0=none"}), HasSubstr("none removes a key, not an entry"));
}

struct BadOverride {
  std::string text;
  std::string what;
};

class Overrides : public ::testing::TestWithParam<BadOverride> {};

TEST_P(Overrides, AreRefusedByTheirText) {
  const std::string errors = errors_of(CaseText().file(), {GetParam().text});
  EXPECT_THAT(errors, HasSubstr("--set " + GetParam().text));
  EXPECT_THAT(errors, HasSubstr(GetParam().what));
}

INSTANTIATE_TEST_SUITE_P(
    CaseFile, Overrides,
    ::testing::Values(BadOverride{"time.end", "must be key.path=value"},
                      BadOverride{"=3", "must be key.path=value"},
                      BadOverride{"output.probe.7.name=top", "no such key"},
                      BadOverride{"output.probe.7=3", "no such key"},
                      BadOverride{"output.probe.99999999999999999999=3", "no such key"},
                      BadOverride{"output.probe.=3", "no such key"},
                      BadOverride{"output.probe.tip.name=top", "no such key"},
                      BadOverride{"title.more=3", "no such key"}, BadOverride{"title.a.b=3", "no such key"},
                      BadOverride{"fluid.spacing=-1", "fluid.spacing: -1 must be > 0 [m]"},
                      BadOverride{"fluid.spacing=thick", "fluid.spacing: must be a number"},
                      BadOverride{"fluid.viscosity=1", "fluid.viscosity: unknown key"},
                      BadOverride{"fluid.pressure.levels=1", "fluid.pressure.levels: unknown key"},
                      BadOverride{"gravity=[1, 2, 3]", "gravity: has 3 components, must have 2"},
                      BadOverride{"fluid.tank.max=[0.3, nan]", "fluid.tank.max.1: nan must be finite"},
                      BadOverride{"title=it's", "\"it's\" is neither a TOML value nor a word"}));

TEST(CaseFile, SyntaxErrorsNameTheLine) {
  const CaseText text("density       = 2500.0", "density == 3");
  EXPECT_THAT(errors_of(text.file()),
              HasSubstr(fmt::format("{}:{}: ", text.file(), line_of(text, "density =="))));
}

TEST(CaseFile, AKeyThatIsGivenTwiceIsASyntaxError) {
  const CaseText text("density       = 2500.0", "density = 2500.0\ndensity = 2600.0");
  EXPECT_THAT(errors_of(text.file()),
              HasSubstr(fmt::format("{}:{}: ", text.file(), line_of(text, "density = 2600"))));
}

TEST(CaseFile, AMissingFileIsNamed) {
  EXPECT_THAT(errors_of("/nowhere/at/all.toml"), HasSubstr("/nowhere/at/all.toml: no such case"));
}

TEST(CaseFile, AllErrorsAreReportedAtOnce) {
  const CaseText text("end    = 0.1", "end = -1\nstop = 2");
  const std::string errors = errors_of(text.file(), {"fluid.courant=7", "solid.model=jelly"});
  EXPECT_THAT(errors, HasSubstr("time.end: -1 must be > 0 [s]"));
  EXPECT_THAT(errors, HasSubstr("time.stop: unknown key, allowed: end, window, stepping"));
  EXPECT_THAT(errors, HasSubstr("fluid.courant: 7 must be <= 1"));
  EXPECT_THAT(errors, HasSubstr("solid.model: must be one of: mps, rigid"));
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 3);
}

TEST(CaseFile, WhatAnOverrideLeavesMissingIsPlacedInTheFile) {
  const std::string file = std::string(COSURGE_SOURCE_DIR) + "/cases/hydrostatic/case.toml";
  const std::string errors = errors_of(file, {"solid.model=rigid"});
  EXPECT_THAT(errors, HasSubstr(file + ":"));
  EXPECT_THAT(errors, HasSubstr("solid.density: missing"));
  EXPECT_THAT(errors, Not(HasSubstr("\n:")));
  EXPECT_NE(errors.front(), ':');
}

TEST(CaseFile, ACaseForALaterSchemaIsRefusedByThatAloneWhateverKeysItHas) {
  const CaseText text("[time]", "schema = 2\nsounds = [\"slosh\"]\n[time]");
  const std::string errors = errors_of(text.file());
  EXPECT_THAT(errors, HasSubstr(fmt::format("{}:{}: schema: 2 is newer than Cosurge ", text.file(),
                                            line_of(text, "schema"))));
  EXPECT_THAT(errors, HasSubstr("knows schemas up to 1"));
  EXPECT_THAT(errors, Not(HasSubstr("sounds")));
  EXPECT_THAT(errors_of(CaseText().file(), {"schema=3"}), HasSubstr("--set schema=3: schema: 3 is newer"));
  EXPECT_THAT(errors_of(CaseText().file(), {"schema=0"}), HasSubstr("schema: 0 must be >= 1"));
  EXPECT_EQ(load_case(CaseText("[time]", "schema = 1\n[time]").file()).schema(), 1);
}

TEST(CaseFile, ATextIsReadLikeAFileAndItsErrorsHaveLines) {
  const CaseText text;
  EXPECT_EQ(read_case(text.text()).SerializeAsString(), load_case(text.file()).SerializeAsString());
  try {
    read_case("title = \"x\"\ncolour = 1\n", {}, "/nowhere");
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("case:2: colour: unknown key"));
  }
}

}  // namespace
}  // namespace cosurge
