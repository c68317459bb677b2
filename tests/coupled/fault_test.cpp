// Solvers that fail at a time of the simulation because the user asks for it (--fault).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double patience = 300;  // s: a tenth is enough on an idle machine

class Faults : public ::testing::Test {
 protected:
  void SetUp() override { H5::Exception::dontPrint(); }

  Program run(const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> command = {cosurge_program, "run", small_dam_break, "--out", folder(name),
                                        "--threads",     "1"};
    command.insert(command.end(), more.begin(), more.end());
    command.insert(command.end(), {"--set", "time.end=0.02", "output.frame_interval=0.005"});
    return Program(command, scratch_.path() / (name + ".log"));
  }

  Datasets results(const std::string& name) const { return physics(read_results(folder(name))); }
  fs::path folder(const std::string& name) const { return scratch_.path() / name; }

  ScratchFolder scratch_;
};

struct Failure {
  std::string fault;
  std::string announcement;
  std::string error;
};

TEST_F(Faults, ThatEndARunNameTheSolverAndLetItResumeToTheSameBits) {
  Program whole = run("whole", {});
  ASSERT_EQ(whole.wait(patience), 0) << whole.output();
  for (const auto& [fault, announcement, error] :
       {Failure{"kill:solid@0.007", "--fault: the solid solver is killed",
                "solid_solver 0.1.0: it was killed by signal 9 (Killed)"},
        Failure{"freeze:fluid@0.007", "--fault: the fluid solver is frozen",
                "fluid_solver 0.1.0: the connection was lost: the peer has ended, or has sent no heartbeat "
                "for 3 s"},
        Failure{"corrupt:solid@0.007", "--fault: the solid solver sends a corrupt message",
                "cannot be decoded: it is damaged, truncated or from another program [advance, window"}}) {
    SCOPED_TRACE(fault);
    const std::string name = fault.substr(0, fault.find(':'));
    Program failed = run(name, {"--fault", fault});
    ASSERT_EQ(failed.wait(patience), 1) << failed.output();
    EXPECT_THAT(failed.output(), AllOf(HasSubstr("t = 0.007"), HasSubstr(announcement), HasSubstr(error),
                                       HasSubstr("to resume: cosurge resume")));
    EXPECT_EQ(results(name).at("/frames/time").size(), 2U);
    Program resumed({cosurge_program, "resume", folder(name), "--threads", "1"},
                    scratch_.path() / "resumed.log");
    ASSERT_EQ(resumed.wait(patience), 0) << resumed.output();
    EXPECT_EQ(results(name), results("whole"));
  }
}

TEST_F(Faults, ADelayIsWaitedForAndChangesNothing) {
  Program whole = run("whole", {"--in-process"});
  ASSERT_EQ(whole.wait(patience), 0) << whole.output();
  const auto begin = std::chrono::steady_clock::now();
  Program late = run("late", {"--fault", "delay:fluid@0.01", "delay:solid@0.0"});
  ASSERT_EQ(late.wait(patience), 0) << late.output();
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  EXPECT_THAT(late.output(), AllOf(HasSubstr("t = 0 s: --fault: the solid solver answers 5 s late"),
                                   HasSubstr("t = 0.01 s: --fault: the fluid solver answers 5 s late")));
  EXPECT_EQ(results("late"), results("whole"));
}

TEST_F(Faults, OfSolversInThreadsAreThoseOfTheirMessages) {
  Program corrupt = run("corrupt", {"--in-process", "--fault", "corrupt:fluid@0"});
  EXPECT_EQ(corrupt.wait(patience), 1) << corrupt.output();
  EXPECT_THAT(corrupt.output(), HasSubstr("cannot be decoded"));
  Program killed = run("killed", {"--in-process", "--fault", "kill:fluid@0"});
  EXPECT_EQ(killed.wait(patience), 1) << killed.output();
  EXPECT_THAT(killed.output(), HasSubstr("the fluid solver is not a process that this run starts"));
  EXPECT_FALSE(fs::exists(folder("killed")));
}

TEST_F(Faults, ThatAreWronglyAskedForAreNamedAtOnce) {
  Program program = run("wrong", {"--fault", "kill", "burn:solid@0.01", "kill:gas@0.01", "kill:solid@1",
                                  "freeze:solid@-0.1", "delay:solid@soon"});
  EXPECT_EQ(program.wait(patience), 1);
  EXPECT_THAT(program.output(),
              AllOf(HasSubstr("--fault kill: must be KIND:SOLVER@TIME, for instance kill:solid@0.05"),
                    HasSubstr("--fault burn:solid@0.01: \"burn\" must be kill, freeze, delay or corrupt"),
                    HasSubstr("--fault kill:gas@0.01: \"gas\" must be one of fluid, solid"),
                    HasSubstr("--fault kill:solid@1: the time must be >= 0 and < time.end = 0.02 [s]"),
                    HasSubstr("--fault freeze:solid@-0.1: the time"),
                    HasSubstr("--fault delay:solid@soon: the time")));
  EXPECT_FALSE(fs::exists(folder("wrong")));
}

}  // namespace
}  // namespace cosurge::testing
