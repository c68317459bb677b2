// Data that a run, a resumption or a kill could lose, leave behind or overwrite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

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

class NothingLost : public ::testing::Test {
 protected:
  void SetUp() override {
    H5::Exception::dontPrint();
    fs::create_directories(temporary());
  }

  /// With its own folder for temporary files.
  Program cosurge(const std::vector<std::string>& arguments, const std::string& name) {
    std::vector<std::string> command = {"/usr/bin/env", "TMPDIR=" + temporary().string(), cosurge_program};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return Program(command, scratch_.path() / (name + ".log"));
  }

  Program run(const std::string& end, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"run", small_dam_break, "--out", folder(), "--threads", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"--set", "time.end=" + end, "output.frame_interval=0.002"});
    return cosurge(arguments, "run");
  }

  Program resume() { return cosurge({"resume", folder(), "--threads", "1", "--in-process"}, "resume"); }

  static void wait_for_file(const fs::path& path, Program& program) {
    while (!fs::exists(path) && program.running()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }

  std::string text_of(const fs::path& path) const {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  fs::path folder() const { return scratch_.path() / "run"; }
  fs::path temporary() const { return scratch_.path() / "t"; }

  ScratchFolder scratch_;
};

TEST_F(NothingLost, TheStatusOfARunSaysHowFarItIsAndHowToGoOn) {
  Program program = run("1000");
  wait_for_file(folder() / "checkpoint.old", program);
  Program running = cosurge({"status", folder()}, "running");
  ASSERT_EQ(running.wait(patience), 0) << running.output();
  EXPECT_THAT(running.output(), HasSubstr("running\n  t = "));
  EXPECT_THAT(running.output(), HasSubstr("of 1000 s (0 %) at the last frame"));
  EXPECT_THAT(running.output(), HasSubstr(" left; last frame"));
  kill(program.pid(), SIGKILL);
  program.wait(patience);
  Program killed = cosurge({"status", folder()}, "killed");
  ASSERT_EQ(killed.wait(patience), 0) << killed.output();
  EXPECT_THAT(killed.output(), HasSubstr("killed\n"));
  EXPECT_THAT(killed.output(), HasSubstr("cosurge resume " + folder().string()));
  Program none = cosurge({"status", scratch_.path() / "none"}, "none");
  EXPECT_EQ(none.wait(patience), 1);
  EXPECT_THAT(none.output(), HasSubstr("contains no run"));
}

// A stopped process keeps every signal waiting except SIGKILL.
TEST_F(NothingLost, AFrozenSolverEndsWithACouplerThatIsKilled) {
  Program program = run("1000");
  ASSERT_TRUE(program.says("results:", patience)) << program.output();
  const auto solvers = children_of(program.pid());
  ASSERT_EQ(solvers.size(), 2U);
  for (const auto& [pid, name] : solvers) kill(pid, SIGSTOP);
  kill(program.pid(), SIGKILL);
  program.wait(patience);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  for (const auto& [pid, name] : solvers) {
    EXPECT_FALSE(lives(pid)) << name << " was left behind";
    kill(pid, SIGKILL);
  }
}

TEST_F(NothingLost, TheTemporaryFolderOfARunThatWasKilledGoesWithTheNextRun) {
  Program killed = run("1000");
  ASSERT_TRUE(killed.says("results:", patience)) << killed.output();
  kill(killed.pid(), SIGKILL);
  killed.wait(patience);
  EXPECT_FALSE(fs::is_empty(temporary())) << "nothing to clean up: nothing was tested";
  Program next = cosurge({"run", small_dam_break, "--out", scratch_.path() / "next", "--in-process", "--set",
                          "time.end=0.002", "output.frame_interval=0.002"},
                         "next");
  ASSERT_EQ(next.wait(patience), 0) << next.output();
  EXPECT_TRUE(fs::is_empty(temporary()));
}

TEST_F(NothingLost, ResultsThatAreRemovedDuringARunAreWrittenAgain) {
  Program whole = cosurge({"run", small_dam_break, "--out", scratch_.path() / "whole", "--in-process",
                           "--threads", "1", "--set", "time.end=0.1", "output.frame_interval=0.002"},
                          "whole");
  ASSERT_EQ(whole.wait(patience), 0) << whole.output();
  Program program = run("0.1", {"--in-process"});
  wait_for_file(folder() / "results.xdmf", program);
  fs::remove(folder() / "results.h5");
  ASSERT_EQ(program.wait(patience), 1) << program.output();
  EXPECT_THAT(program.output(),
              HasSubstr("results.h5: was removed during the run; it has been written again in full"));
  EXPECT_THAT(program.output(), HasSubstr("to resume: cosurge resume"));
  EXPECT_GE(read_results(folder()).at("/frames/time").size(), 2U);
  Program resumed = resume();
  ASSERT_EQ(resumed.wait(patience), 0) << resumed.output();
  EXPECT_EQ(physics(read_results(folder())), physics(read_results(scratch_.path() / "whole")));
}

TEST_F(NothingLost, ALinkOrFileInThePlaceOfAResultIsNeitherFollowedNorReplaced) {
  const fs::path elsewhere = scratch_.path() / "elsewhere";
  for (const char* name : {"results.xdmf", "results.xdmf.new", "summary.json.new", "checkpoint.new",
                           "checkpoint.old.new", "fluid_solver.log", "solid_solver.log", "results.h5"}) {
    fs::remove_all(folder());
    fs::create_directories(folder());
    fs::create_symlink(elsewhere, folder() / name);
    Program program = run("0.002");
    EXPECT_EQ(program.wait(patience), 1) << name;
    EXPECT_THAT(program.output(), HasSubstr("holds results already; choose another --out")) << name;
    EXPECT_FALSE(fs::exists(elsewhere)) << name;
  }
}

TEST_F(NothingLost, AResumptionFollowsNoLinkAndKeepsTheLogs) {
  Program program = run("1000");
  wait_for_file(folder() / "checkpoint", program);
  kill(program.pid(), SIGINT);
  ASSERT_EQ(program.wait(patience), 130) << program.output();
  std::ofstream(folder() / "fluid_solver.log") << "what the first part has said\n";
  const fs::path elsewhere = scratch_.path() / "elsewhere";
  std::ofstream(elsewhere) << "precious\n";
  for (const char* name : {"summary.json.new", "checkpoint.new", "results.xdmf.new"})
    fs::create_symlink(elsewhere, folder() / name);
  Program resumed = cosurge({"resume", folder(), "--threads", "1", "--set", "time.end=0.2"}, "resume");
  ASSERT_TRUE(resumed.says("resumed at", patience)) << resumed.output();
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  kill(resumed.pid(), SIGINT);
  resumed.wait(patience);
  EXPECT_EQ(text_of(elsewhere), "precious\n");
  EXPECT_THAT(text_of(folder() / "fluid_solver.log"), HasSubstr("what the first part has said"));
}

TEST_F(NothingLost, WhatACaseSaysCannotWriteToATerminal) {
  fs::create_directories(scratch_.path() / "scene");
  std::string text = text_of(small_dam_break + "/case.toml");
  const std::string title = "title   = \"Small dam break";
  const auto at = text.find(title);
  ASSERT_NE(at, std::string::npos);
  text.insert(at + title.size(), "\\u001B]0;owned\\u0007\\u009B31m");
  std::ofstream(scratch_.path() / "scene/case.toml") << text;
  for (const char* command : {"run", "check"}) {
    std::vector<std::string> arguments = {command, scratch_.path() / "scene"};
    if (command == std::string("run")) arguments.insert(arguments.end(), {"--out", folder(), "--in-process"});
    arguments.insert(arguments.end(), {"--set", "time.end=0.002"});
    Program program = cosurge(arguments, command);
    ASSERT_EQ(program.wait(patience), 0) << program.output();
    EXPECT_THAT(program.output(), HasSubstr("Small dam break?]0;owned??31m")) << command;
    EXPECT_THAT(program.output(), Not(HasSubstr("\x1b"))) << command;
  }
  Program wrong = cosurge({"check", scratch_.path() / "none\x1b]0;owned\x07"}, "wrong");
  EXPECT_EQ(wrong.wait(patience), 1);
  EXPECT_THAT(wrong.output(), HasSubstr("?]0;owned?"));
  EXPECT_THAT(wrong.output(), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace cosurge::testing
