// The real programs, started as a user starts them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;

constexpr double patience = 900;  // s: with sanitizers, on a busy machine; ten is enough on an idle one

class Programs : public ::testing::Test {
 protected:
  /// Starts cosurge run with the small dam break, results in `name`.
  Program start(const std::string& name, std::vector<std::string> arguments) {
    std::vector<std::string> command = {cosurge_program, "run", small_dam_break, "--out", folder(name)};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return Program(command, scratch_.path() / (name + ".log"));
  }

  /// Runs to the end and expects success.
  void run(const std::string& name, std::vector<std::string> arguments) {
    Program program = start(name, std::move(arguments));
    ASSERT_EQ(program.wait(patience), 0) << program.output();
  }

  /// Frames that can be read in the results so far; none where the file is being written just now.
  std::size_t frames(const std::string& name) const {
    try {
      return read_results(folder(name)).at("/frames/time").size();
    } catch (const H5::Exception&) {
      return 0;
    } catch (const std::out_of_range&) {
      return 0;
    }
  }

  /// Runs to the end as `whole`, and as `cut`, which is interrupted and resumed; expects the same bits.
  void run_whole_and_cut(const std::vector<std::string>& arguments);

  void SetUp() override { H5::Exception::dontPrint(); }

  static bool patiently(const std::function<bool()>& reached) {
    for (int tries = 0; tries < 50 * patience; ++tries) {
      if (reached()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }

  fs::path folder(const std::string& name) const { return scratch_.path() / name; }

  ScratchFolder scratch_;
};

void expect_same_bits(const fs::path& first, const fs::path& second) {
  const Datasets a = physics(read_results(first));
  const Datasets b = physics(read_results(second));
  ASSERT_GT(a.size(), 20U);
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, values] : a) {
    ASSERT_TRUE(b.contains(name)) << name;
    const std::vector<double>& others = b.at(name);
    ASSERT_EQ(values.size(), others.size()) << name;
    ASSERT_EQ(std::memcmp(values.data(), others.data(), sizeof(double) * values.size()), 0)
        << name << " differs";
  }
}

void Programs::run_whole_and_cut(const std::vector<std::string>& arguments) {
  run("whole", arguments);
  Program cut = start("cut", arguments);
  ASSERT_TRUE(patiently([&] { return frames("cut") >= 3; }));
  kill(cut.pid(), SIGINT);
  ASSERT_EQ(cut.wait(patience), 130) << cut.output();
  Program resumed({cosurge_program, "resume", folder("cut"), "--in-process"},
                  scratch_.path() / "resumed.log");
  ASSERT_EQ(resumed.wait(patience), 0) << resumed.output();
  expect_same_bits(folder("whole"), folder("cut"));
}

TEST_F(Programs, ALinearModelThatLeftItsRangeSaysSo) {
  Program bent = start("bent", {"--set", "solid.model=modal", "solid.young_modulus=2e4", "time.end=0.3"});
  ASSERT_EQ(bent.wait(patience), 0) << bent.output();
  EXPECT_NE(bent.output().find("the model modal is linear and valid up to 5 %"), std::string::npos)
      << bent.output();
  Program stiff = start("stiff", {"--set", "solid.model=modal", "solid.young_modulus=1e9", "time.end=0.3"});
  ASSERT_EQ(stiff.wait(patience), 0) << stiff.output();
  EXPECT_EQ(stiff.output().find("linear"), std::string::npos) << stiff.output();
}

TEST_F(Programs, ThreeProcessesAndOneGiveTheSameBits) {
  run("processes", {});
  run("threads", {"--in-process"});
  expect_same_bits(folder("processes"), folder("threads"));
  const Datasets results = read_results(folder("processes"));
  double largest = 0;
  for (const double tip : results.at("/history/solid/tip_x")) largest = std::max(largest, tip);
  EXPECT_GT(largest, 1e-4) << "the water must have moved the plate, or nothing was compared";
}

TEST_F(Programs, OneAndTwoThreadsGiveTheSameBits) {
  // 8.1e3 unknowns and more than the 4096 terms from which loops are shared among threads.
  const std::vector<std::string> finer = {"--set", "fluid.spacing=0.002", "time.end=0.12"};
  for (const std::string threads : {"1", "2"}) {
    std::vector<std::string> arguments = finer;
    arguments.insert(arguments.end(), {"--threads", threads});
    run("threads" + threads, arguments);
  }
  expect_same_bits(folder("threads1"), folder("threads2"));
}

TEST_F(Programs, OneWordMakesThePlateRigid) {
  run("rigid", {"--set", "solid.model=rigid"});
  const Datasets results = read_results(folder("rigid"));
  double force = 0;
  for (const double f : results.at("/history/coupling/force_x")) force = std::max(force, f);
  EXPECT_GT(force, 1.0) << "the water must have reached the plate";
  for (const double tip : results.at("/history/solid/tip_x")) ASSERT_EQ(tip, 0.0);
}

TEST_F(Programs, WorkOnTheInterfaceIsTheSameOnBothSides) {
  for (const std::string load : {"held", "ramped"}) {
    run(load, {"--set", "coupling.load=" + load});
    const nlohmann::json work = read_summary(folder(load)).at("interface_work");
    const double points = work.at("points");
    EXPECT_GT(std::abs(points), 1e-4);
    // Two sums of some 1e5 products of the same numbers in different order.
    EXPECT_NEAR(points, work.at("solid").get<double>(), 1e-12 * std::abs(points)) << load;
  }
}

TEST_F(Programs, NoWaterIsLostAndNoneEntersThePlate) {
  run("water", {});
  const Datasets results = read_results(folder("water"));
  for (const double lost : results.at("/history/fluid/lost")) ASSERT_EQ(lost, 0);
  for (const double inside : results.at("/history/fluid/inside_bodies")) ASSERT_EQ(inside, 0);
}

TEST_F(Programs, AKilledSolverEndsTheRunInWordsAndLeavesReadableResults) {
  for (const std::string victim : {"fluid_solver", "solid_solver"}) {
    Program program = start(victim, {"--set", "time.end=20"});
    ASSERT_TRUE(program.says("window ", patience)) << program.output();
    const auto children = children_of(program.pid());
    EXPECT_EQ(children.size(), 2U);
    for (const auto& [pid, name] : children)
      if (name == victim) kill(pid, SIGKILL);
    EXPECT_EQ(program.wait(10), 1) << program.output();
    EXPECT_NE(program.output().find(victim), std::string::npos) << program.output();
    EXPECT_NE(program.output().find("signal 9"), std::string::npos) << program.output();
    for (const auto& [pid, name] : children) EXPECT_NE(kill(pid, 0), 0) << name << " was left behind";
    EXPECT_EQ(read_summary(folder(victim)).at("status"), "failed");
    const Datasets results = read_results(folder(victim));
    EXPECT_GT(results.at("/history/time").size(), 100U);
    EXPECT_GE(results.at("/frames/time").size(), 2U);
  }
}

TEST_F(Programs, AnInterruptEndsTheRunAndKeepsWhatItHas) {
  Program program = start("interrupted", {"--set", "time.end=20"});
  ASSERT_TRUE(program.says("window ", patience)) << program.output();
  const auto children = children_of(program.pid());
  kill(program.pid(), SIGINT);
  EXPECT_EQ(program.wait(10), 130) << program.output();
  EXPECT_EQ(read_summary(folder("interrupted")).at("status"), "interrupted");
  EXPECT_GT(read_results(folder("interrupted")).at("/history/time").size(), 100U);
  for (const auto& [pid, name] : children) EXPECT_NE(kill(pid, 0), 0) << name << " was left behind";
}

TEST_F(Programs, AnInterruptedRunResumesToTheSameBits) {
  run("whole", {"--in-process"});
  Program cut = start("cut", {});
  // Frames are 0.02 s apart: this is after the third, in the middle of an interval.
  ASSERT_TRUE(patiently([&] { return frames("cut") >= 3; }));
  kill(cut.pid(), SIGINT);
  ASSERT_EQ(cut.wait(patience), 130) << cut.output();
  const std::size_t rows = read_results(folder("cut")).at("/history/time").size();
  Program resumed({cosurge_program, "resume", folder("cut")}, scratch_.path() / "resumed.log");
  ASSERT_EQ(resumed.wait(patience), 0) << resumed.output();
  EXPECT_LT(rows, read_results(folder("cut")).at("/history/time").size())
      << "the run was over before it was cut";
  expect_same_bits(folder("whole"), folder("cut"));
  Program again({cosurge_program, "resume", folder("cut")}, scratch_.path() / "again.log");
  EXPECT_EQ(again.wait(patience), 1);
  EXPECT_NE(again.output().find("the run is finished"), std::string::npos) << again.output();
}

TEST_F(Programs, AnInterruptedRunWithTheAddedMassOfModesResumesToTheSameBits) {
  for (const std::string scheme : {"weak_inertial", "strong_inertial"}) {
    run_whole_and_cut({"--set", "coupling.scheme=" + scheme, "coupling.velocity=end", "fluid.source=mixed",
                       "solid.model=modal"});
    const auto results = read_results(folder("whole"));
    const std::vector<double>& ratio = results.at("/history/fluid/modes_mass_ratio");
    EXPECT_GT(*std::max_element(ratio.begin(), ratio.end()), 0.05) << "the water must have reached the plate";
    fs::remove_all(folder("whole"));
    fs::remove_all(folder("cut"));
  }
}

TEST_F(Programs, TheSelftestAgreesWithTheory) {
  Program selftest({cosurge_program, "selftest"}, scratch_.path() / "selftest.log");
  EXPECT_EQ(selftest.wait(patience), 0) << selftest.output();
  EXPECT_EQ(selftest.output().find("FAILED"), std::string::npos);
}

TEST_F(Programs, AMapHasARowForEveryCellAndSaysWhatFailed) {
  const fs::path table = folder("map.csv");
  Program map({cosurge_program, "map", small_dam_break, "--set", "time.end=0.01", "solid.model=modal",
               "--over", "coupling.scheme=weak,strong", "--over", "solid.density=1000,-1", "--out", table},
              scratch_.path() / "map.log");
  ASSERT_EQ(map.wait(patience), 0) << map.output();
  std::ifstream file(table);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_TRUE(lines[0].starts_with("# cosurge map "));
  EXPECT_TRUE(lines[1].starts_with("coupling.scheme,solid.density,state,"));
  EXPECT_TRUE(lines[2].starts_with("weak,1000,stable,0.01,50,1.000,"));
  EXPECT_TRUE(lines[3].starts_with("weak,-1,refused,"));
  EXPECT_NE(lines[3].find("solid.density"), std::string::npos);
  EXPECT_TRUE(lines[4].starts_with("strong,1000,stable,0.01,50,"));
}

// A floor four times lighter than its water: twice the limit of weak coupling (soft_floor_test.cpp).
TEST_F(Programs, ARunThatTheSchemeItselfHasDrivenSaysSo) {
  for (const std::string scheme : {"weak", "strong"}) {
    Program program({cosurge_program, "run", COSURGE_SOURCE_DIR "/cases/soft_floor", "--out", folder(scheme),
                     "--set", "coupling.scheme=" + scheme, "time.end=0.02"},
                    scratch_.path() / (scheme + ".log"));
    EXPECT_EQ(program.wait(patience), 0) << program.output();
    for (const char* words : {"warning: unreliable result", "% of the work done, limit 5 %"})
      EXPECT_EQ(program.output().find(words) != std::string::npos, scheme == "weak") << program.output();
  }
}

TEST_F(Programs, AnInterruptedRunOfStrongCouplingResumesToTheSameBits) {
  const std::vector<std::string> strong = {"--set", "coupling.scheme=strong",
                                           "coupling.prediction=extrapolated", "fluid.source=mixed",
                                           "solid.model=modal"};
  run_whole_and_cut(strong);
  const nlohmann::json coupling = read_summary(folder("whole")).at("coupling");
  EXPECT_GT(coupling.at("most_iterations"), 2);
  EXPECT_EQ(coupling.at("unconverged"), 0);
}

TEST_F(Programs, ARunWhoseSolverWasKilledResumesFromItsLastFrameToTheSameBits) {
  run("whole", {});
  Program cut = start("cut", {});
  ASSERT_TRUE(patiently([&] { return frames("cut") >= 3; }));
  for (const auto& [pid, name] : children_of(cut.pid()))
    if (name == "solid_solver") kill(pid, SIGKILL);
  ASSERT_EQ(cut.wait(patience), 1) << cut.output();
  Program resumed({cosurge_program, "resume", folder("cut"), "--in-process"},
                  scratch_.path() / "resumed.log");
  ASSERT_EQ(resumed.wait(patience), 0) << resumed.output();
  expect_same_bits(folder("whole"), folder("cut"));
}

TEST_F(Programs, ASolverStartedByHandJoinsOnASocketAndOverTcp) {
  for (const std::string where : {"solid", "solid=tcp://127.0.0.1:*"}) {
    const std::string name = where.find("tcp") == std::string::npos ? "socket" : "tcp";
    Program program = start(name, {"--by-hand", where, "--set", "time.end=0.02"});
    ASSERT_TRUE(program.says(".connection", patience)) << program.output();
    std::istringstream words(program.output().substr(program.output().find("solid_solver")));
    std::vector<std::string> command{std::istream_iterator<std::string>(words), {}};
    command.front() = fs::path(COSURGE_PROGRAMS) / "solid_solver";
    command.resize(3);  // solid_solver --connect FILE
    Program solver(command, scratch_.path() / "solver.log");
    EXPECT_EQ(program.wait(patience), 0) << program.output() << solver.output();
    EXPECT_EQ(solver.wait(10), 0) << solver.output();
  }
  expect_same_bits(folder("socket"), folder("tcp"));
}

TEST_F(Programs, WaitingForASolverCanBeInterrupted) {
  Program program = start("waiting", {"--by-hand", "solid"});
  ASSERT_TRUE(program.says(".connection", patience)) << program.output();
  kill(program.pid(), SIGINT);
  EXPECT_EQ(program.wait(10), 130) << program.output();
}

TEST_F(Programs, ResultsAreNotWrittenOver) {
  run("once", {"--set", "time.end=0.002", "output.frame_interval=0.001"});
  const auto before = fs::last_write_time(folder("once") / "results.h5");
  Program again = start("once", {});
  EXPECT_EQ(again.wait(patience), 1);
  EXPECT_NE(again.output().find("holds results already"), std::string::npos) << again.output();
  EXPECT_EQ(fs::last_write_time(folder("once") / "results.h5"), before);
}

TEST_F(Programs, ABadCaseIsRefusedBeforeAnythingIsWritten) {
  Program program = start("bad", {"--set", "fluid.spacing=0.005", "solid.density=-1"});
  EXPECT_EQ(program.wait(patience), 1);
  EXPECT_NE(program.output().find("solid.density: -1 must be > 0 [kg/m3]"), std::string::npos)
      << program.output();
  EXPECT_FALSE(fs::exists(folder("bad")));
}

TEST_F(Programs, CheckSaysWhatWouldRun) {
  Program program({cosurge_program, "check", small_dam_break}, scratch_.path() / "check.log");
  EXPECT_EQ(program.wait(patience), 0);
  for (const std::string word : {"valid", "particles", "windows", "memory", "time"})
    EXPECT_NE(program.output().find(word), std::string::npos) << program.output();
}

TEST_F(Programs, EveryCaseOfTheProjectIsValid) {
  for (const auto& entry : fs::directory_iterator(COSURGE_SOURCE_DIR "/cases")) {
    if (!fs::exists(entry.path() / "case.toml")) continue;
    Program program({cosurge_program, "check", entry.path()}, scratch_.path() / "check.log");
    EXPECT_EQ(program.wait(patience), 0) << program.output();
  }
}

}  // namespace
}  // namespace cosurge::testing
