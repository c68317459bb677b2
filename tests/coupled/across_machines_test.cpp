// A run whose structure is computed at another address, with keys.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <iterator>
#include <sstream>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/second_address.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double patience = 300;  // s: a tenth is enough on an idle machine

class AcrossMachines : public ::testing::Test {
 protected:
  /// A program with the keys of a machine.
  Program on(const std::string& machine, const std::string& log, std::vector<std::string> command) {
    command.insert(command.begin(),
                   {"/usr/bin/env", "XDG_CONFIG_HOME=" + (scratch_.path() / machine).string()});
    return Program(command, scratch_.path() / log);
  }

  /// What cosurge keys prints on a machine.
  std::string keys(const std::string& machine) {
    Program program = on(machine, "keys.log", {cosurge_program, "keys"});
    EXPECT_EQ(program.wait(patience), 0) << program.output();
    return program.output();
  }

  Program run(const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> command = {
        cosurge_program, "run", small_dam_break, "--out", scratch_.path() / name, "--threads", "1"};
    command.insert(command.end(), more.begin(), more.end());
    command.insert(command.end(), {"--set", "time.end=0.01", "output.frame_interval=0.005"});
    return on("here", name + ".log", command);
  }

  /// The command that a run prints for its solid solver.
  static std::vector<std::string> printed_command(Program& program) {
    EXPECT_TRUE(program.says(".connection", patience)) << program.output();
    std::istringstream words(program.output().substr(program.output().find("solid_solver --")));
    std::vector<std::string> command{std::istream_iterator<std::string>(words), {}};
    command.front() = fs::path(COSURGE_PROGRAMS) / "solid_solver";
    command.resize(3);  // solid_solver --connect FILE
    return command;
  }

  ScratchFolder scratch_;
};

TEST_F(AcrossMachines, KeysAreMadeAtTheFirstCallAndListedAtEveryOne) {
  const std::string first = keys("there"), second = keys("there");
  EXPECT_THAT(first, HasSubstr("made now"));
  EXPECT_THAT(first, HasSubstr((scratch_.path() / "there/cosurge/secret_key").string()));
  EXPECT_EQ(second.substr(second.rfind('\n', second.size() - 2)),
            first.substr(first.rfind('\n', first.size() - 2)));
  EXPECT_NE(keys("elsewhere"), second);
}

TEST_F(AcrossMachines, ARunGivesTheSameBitsAndTakesNoMachineThatIsNotAllowed) {
  std::string address = second_address();
  if (address.empty()) address = "127.0.0.2";
  const fs::path allowed = scratch_.path() / "allowed";
  std::ofstream(allowed) << keys("there");
  keys("foreign");
  Program whole = run("whole", {});
  ASSERT_EQ(whole.wait(patience), 0) << whole.output();
  Program program = run("apart", {"--by-hand", "solid=tcp://" + address + ":*", "--allow", allowed});
  const std::vector<std::string> command = printed_command(program);
  Program foreign = on("foreign", "foreign.log", command);
  EXPECT_EQ(foreign.wait(patience), 1) << foreign.output();
  EXPECT_THAT(foreign.output(), HasSubstr("the coupler does not allow the key of this machine"));
  Program solver = on("there", "solver.log", command);
  EXPECT_EQ(program.wait(patience), 0) << program.output() << solver.output();
  EXPECT_EQ(solver.wait(10), 0) << solver.output();
  EXPECT_EQ(physics(read_results(scratch_.path() / "whole")),
            physics(read_results(scratch_.path() / "apart")));
}

TEST_F(AcrossMachines, ARunThatOthersCouldJoinNeedsAListOfKeys) {
  int number = 0;
  for (const std::string where : {"solid=tcp://*:*", "solid=tcp://0.0.0.0:*"}) {
    const std::string name = fmt::format("open{}", ++number);
    Program program = run(name, {"--by-hand", where});
    EXPECT_EQ(program.wait(patience), 1) << program.output();
    EXPECT_THAT(program.output(), HasSubstr("without keys: other machines can reach it"));
    EXPECT_FALSE(fs::exists(scratch_.path() / name / "results.h5"));
  }
  const fs::path allowed = scratch_.path() / "allowed";
  std::ofstream(allowed) << "there tooshort\n";
  Program wrong = run("wrong", {"--by-hand", "solid=tcp://*:*", "--allow", allowed});
  EXPECT_EQ(wrong.wait(patience), 1) << wrong.output();
  EXPECT_THAT(wrong.output(), HasSubstr("allowed:1: must have a name and a public key"));
  Program useless = run("useless", {"--allow", allowed});
  EXPECT_EQ(useless.wait(patience), 1) << useless.output();
  EXPECT_THAT(useless.output(),
              HasSubstr("--allow is for a solver that somebody else starts at a tcp:// address"));
}

}  // namespace
}  // namespace cosurge::testing
