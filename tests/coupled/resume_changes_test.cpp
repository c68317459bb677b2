// Resumptions with changes, and the advice of a run at its end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "coupler/checkpoint.hpp"
#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double patience = 900;  // s: with sanitizers, on a busy machine

class ResumeWithChanges : public ::testing::Test {
 protected:
  void SetUp() override { H5::Exception::dontPrint(); }

  /// Output of a command that must end with the status.
  std::string output_of(int status, std::vector<std::string> command) {
    command.insert(command.begin(), cosurge_program);
    for (const char* word : {"--in-process", "--threads", "1"}) command.emplace_back(word);
    Program program(command, scratch_.path() / "log");
    EXPECT_EQ(program.wait(patience), status) << program.output();
    return program.output();
  }
  std::string run(const std::string& name, const std::vector<std::string>& settings,
                  const std::string& which = small_dam_break, int status = 0) {
    return output_of(status, with_settings({"run", which, "--out", folder(name)}, settings));
  }
  std::string resume(const std::string& name, const std::vector<std::string>& settings, int status = 0) {
    return output_of(status, with_settings({"resume", folder(name)}, settings));
  }
  Datasets results(const std::string& name) const { return physics(read_results(folder(name))); }
  fs::path folder(const std::string& name) const { return scratch_.path() / name; }

  ScratchFolder scratch_;

 private:
  static std::vector<std::string> with_settings(std::vector<std::string> command,
                                                const std::vector<std::string>& settings) {
    if (settings.empty()) return command;
    command.emplace_back("--set");
    command.insert(command.end(), settings.begin(), settings.end());
    return command;
  }
};

TEST_F(ResumeWithChanges, AFinishedRunIsMadeLongerToTheSameBits) {
  run("whole", {"time.end=0.08"});
  run("longer", {"time.end=0.04"});
  EXPECT_THAT(resume("longer", {"time.end=0.08"}), HasSubstr("time.end: 0.04, now 0.08"));
  const Datasets a = results("whole"), b = results("longer");
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, values] : a) {
    ASSERT_EQ(values.size(), b.at(name).size()) << name;
    EXPECT_EQ(std::memcmp(values.data(), b.at(name).data(), sizeof(double) * values.size()), 0) << name;
  }
}

TEST_F(ResumeWithChanges, AnEndBetweenFramesAndOtherIntervalsKeepFramesAtTheirMultiples) {
  run("run", {"time.end=0.05"});
  resume("run", {"time.end=0.08"});
  EXPECT_THAT(results("run").at("/frames/time"), ::testing::ElementsAre(0, 0.02, 0.04, 0.05, 0.06, 0.08));
  resume("run", {"time.end=0.11", "output.frame_interval=0.01"});
  EXPECT_THAT(results("run").at("/frames/time").size(), 9U);
}

TEST_F(ResumeWithChanges, SchemeAndWindowsMayChange) {
  run("run", {"time.end=0.04"});
  const std::string said = resume("run", {"time.end=0.06", "coupling.scheme=strong", "time.window=1e-4"});
  EXPECT_THAT(said, HasSubstr("coupling.scheme: 'auto', now 'strong'"));
  const Datasets now = results("run");
  const std::size_t before = 200;  // windows of 2e-4 s
  EXPECT_EQ(now.at("/history/coupling/iterations")[before - 1], 1);
  EXPECT_GE(now.at("/history/coupling/iterations")[before + 1], 2);
  EXPECT_NEAR(now.at("/history/window").back(), 1e-4, 1e-9);
  // The changes stay with the results.
  const H5::H5File file((folder("run") / "results.h5").string(), H5F_ACC_RDONLY);
  const H5::Attribute changes = file.openAttribute("changes");
  std::string text;
  changes.read(changes.getStrType(), text);
  EXPECT_THAT(text, HasSubstr("t = 0.04 s: coupling.scheme: 'auto', now 'strong'"));
}

TEST_F(ResumeWithChanges, FixedWindowsMayChangeWhereTheyReachTheCheckpoint) {
  run("run", {"time.end=0.04", "time.stepping=fixed"});
  EXPECT_THAT(resume("run", {"time.end=0.06", "time.window=3e-4", "output.frame_interval=0.06"}, 1),
              HasSubstr("is not a whole number of fixed windows"));
  resume("run", {"time.end=0.06", "time.window=1e-4"});
  const Datasets now = results("run");
  EXPECT_EQ(now.at("/history/time").size(), 400U);
  EXPECT_NEAR(now.at("/history/time").back(), 0.06, 1e-12);
}

TEST_F(ResumeWithChanges, WhatAStateDependsOnIsRefusedAllAtOnceAndNothingIsWritten) {
  run("run", {"time.end=0.04"});
  const auto before = fs::last_write_time(folder("run") / "results.h5");
  const std::string said = resume("run", {"fluid.spacing=0.002", "solid.model=rigid"}, 1);
  for (const char* words : {"--set fluid.spacing: cannot be changed by resume (0.004)",
                            "--set solid.model:", "time.end: 0.04 s must be > 0.04 s"})
    EXPECT_THAT(said, HasSubstr(words));
  EXPECT_EQ(fs::last_write_time(folder("run") / "results.h5"), before);
  EXPECT_THAT(resume("run", {}, 1),
              HasSubstr("the run is finished at t = 0.04 s; --set time.end=... extends it"));
}

TEST_F(ResumeWithChanges, AKeyThatIsNewerThanTheRunIsNoChange) {
  run("run", {"time.end=0.04"});
  Checkpoint checkpoint = Checkpoint::read(folder("run"));
  checkpoint.the_case.clear_schema();
  checkpoint.the_case.mutable_fluid()->clear_most_lost();
  checkpoint.write(folder("run"));
  const std::string said = resume("run", {"time.end=0.06"});
  EXPECT_THAT(said, HasSubstr("time.end: 0.04, now 0.06"));
  EXPECT_THAT(said, Not(HasSubstr("schema")));
  EXPECT_THAT(said, Not(HasSubstr("most_lost")));
}

TEST_F(ResumeWithChanges, ACaseFileThatHasChangedSinceIsTold) {
  const fs::path own = scratch_.path() / "case";
  fs::copy(small_dam_break, own, fs::copy_options::recursive);
  run("run", {"time.end=0.02"}, own);
  EXPECT_THAT(resume("run", {"time.end=0.04"}), Not(HasSubstr("has changed")));
  std::ifstream file(own / "case.toml");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  text.replace(text.find("2500.0"), 6, "2600.0");
  std::ofstream(own / "case.toml") << text;
  EXPECT_THAT(resume("run", {"time.end=0.06"}),
              AllOf(HasSubstr("case.toml has changed since the start of the run"),
                    HasSubstr("solid.density: 2500 in the run, 2600 in the file")));
}

TEST_F(ResumeWithChanges, ABrokenDownComputationIsNotAdvisedToGoOnAsItIs) {
  const std::string said =
      run("run", {"coupling.scheme=weak", "solid.fem.rho_infinity=0.8", "fluid.source=mixed"},
          COSURGE_SOURCE_DIR "/cases/soft_floor", 1);
  EXPECT_THAT(said, AllOf(HasSubstr("without changes would fail at the same window"),
                          Not(HasSubstr("to resume: cosurge resume"))));
}

}  // namespace
}  // namespace cosurge::testing
