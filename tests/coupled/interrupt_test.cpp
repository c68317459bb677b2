// Signals to a run whose solvers do not answer.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr double patience = 900;  // s: with sanitizers, on a busy machine

class Interrupt : public ::testing::Test {
 protected:
  Program start(const std::vector<std::string>& more) {
    std::vector<std::string> command = {cosurge_program, "run", small_dam_break, "--out", folder()};
    command.insert(command.end(), more.begin(), more.end());
    return Program(command, scratch_.path() / "log");
  }

  /// Sends `signals`, a tenth of a second apart, and returns the seconds from the first one to the end.
  double seconds_to_end(Program& program, const std::vector<int>& signals) {
    const auto begin = steady_clock::now();
    for (const int signal : signals) {
      kill(program.pid(), signal);
      std::this_thread::sleep_for(milliseconds(100));
    }
    EXPECT_EQ(program.wait(60), 130) << program.output();
    return std::chrono::duration<double>(steady_clock::now() - begin).count();
  }

  void expect_an_interrupted_run(const Program& program) {
    EXPECT_EQ(read_summary(folder()).at("status"), "interrupted");
    EXPECT_NE(program.output().find("to resume: cosurge resume"), std::string::npos) << program.output();
    EXPECT_GE(read_results(folder()).at("/frames/time").size(), 1U);
    EXPECT_TRUE(fs::exists(folder() / "checkpoint"));
  }

  fs::path folder() const { return scratch_.path() / "run"; }

  ScratchFolder scratch_;
};

struct Frozen {
  std::string solver;
  std::vector<int> signals;
  double within;  // s
};

class FrozenSolver : public Interrupt, public ::testing::WithParamInterface<Frozen> {};

TEST_P(FrozenSolver, DoesNotKeepTheRunFromEnding) {
  Program program = start({"--set", "time.end=20"});
  ASSERT_TRUE(program.says("window ", patience)) << program.output();
  const auto children = children_of(program.pid());
  ASSERT_EQ(children.size(), 2U);
  for (const auto& [pid, name] : children)
    if (name == GetParam().solver) kill(pid, SIGSTOP);
  std::this_thread::sleep_for(milliseconds(300));  // the coupler waits for it by now
  EXPECT_LT(seconds_to_end(program, GetParam().signals), GetParam().within);
  for (const auto& [pid, name] : children) EXPECT_NE(kill(pid, 0), 0) << name << " was left behind";
  expect_an_interrupted_run(program);
  Program resumed({cosurge_program, "resume", folder()}, scratch_.path() / "resumed.log");
  EXPECT_TRUE(resumed.says("resumed at t = ", patience)) << resumed.output();
}

INSTANTIATE_TEST_SUITE_P(Programs, FrozenSolver,
                         ::testing::Values(Frozen{"solid_solver", {SIGINT}, 2.5},
                                           Frozen{"fluid_solver", {SIGTERM}, 2.5},
                                           Frozen{"solid_solver", {SIGINT, SIGINT}, 1.0}),
                         [](const auto& test) {
                           return test.param.solver + "_" + std::to_string(test.param.signals.size()) +
                                  "_times_" + std::to_string(test.param.signals.front());
                         });

// The thread of a solver cannot be stopped, and a window of this one takes seconds.
TEST_F(Interrupt, ALongWindowInTheSameProcessIsLeft) {
  Program program = start({"--in-process", "--threads", "1", "--set", "fluid.spacing=0.0005", "time.end=20"});
  ASSERT_TRUE(program.says("results:", patience)) << program.output();
  std::this_thread::sleep_for(milliseconds(500));
  EXPECT_LT(seconds_to_end(program, {SIGINT, SIGINT}), 2.5);
  EXPECT_EQ(read_summary(folder()).at("status"), "interrupted");
}

}  // namespace
}  // namespace cosurge::testing
