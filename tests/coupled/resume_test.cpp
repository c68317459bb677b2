// Runs that are cut off in every order of interruptions and kills: no row and no frame is lost or doubled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double patience = 900;  // s: with sanitizers, on a busy machine

class Resume : public ::testing::Test {
 protected:
  void SetUp() override { H5::Exception::dontPrint(); }

  Program start(const std::string& name, const std::vector<std::string>& settings, bool in_process = true) {
    std::vector<std::string> command = {cosurge_program, "run", small_dam_break, "--out", folder(name),
                                        "--threads",     "1"};
    if (in_process) command.push_back("--in-process");
    command.push_back("--set");
    command.insert(command.end(), settings.begin(), settings.end());
    return Program(command, scratch_.path() / (name + ".log"));
  }

  Program resume(const std::string& name, const std::string& log) {
    return Program({cosurge_program, "resume", folder(name), "--threads", "1", "--in-process"},
                   scratch_.path() / log);
  }

  void finish(const std::string& name, const std::string& log) {
    Program program = resume(name, log);
    ASSERT_EQ(program.wait(patience), 0) << program.output();
  }

  /// Rows of the results; none where they are not there, or are being written just now.
  std::size_t rows(const std::string& name) const {
    try {
      return read_results(folder(name)).at("/history/time").size();
    } catch (const H5::Exception&) {
      return 0;
    } catch (const std::out_of_range&) {
      return 0;
    }
  }

  /// Every row and every frame once, with the same bits.
  void expect_same(const std::string& first, const std::string& second) const {
    const Datasets a = physics(read_results(folder(first)));
    const Datasets b = physics(read_results(folder(second)));
    ASSERT_GT(a.size(), 20U);
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [name, values] : a) {
      ASSERT_EQ(values.size(), b.at(name).size()) << name;
      EXPECT_EQ(std::memcmp(values.data(), b.at(name).data(), sizeof(double) * values.size()), 0) << name;
    }
  }

  fs::path folder(const std::string& name) const { return scratch_.path() / name; }

  ScratchFolder scratch_;
};

void wait_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

// The second checkpoint is from the interruption, between two frames: its rows must be in the new file.
TEST_F(Resume, RowsBeforeAnInterruptionOutliveAResumptionThatIsKilled) {
  const std::vector<std::string> settings = {"time.end=0.4", "output.frame_interval=0.2"};
  Program whole = start("whole", settings);
  ASSERT_EQ(whole.wait(patience), 0) << whole.output();
  Program cut = start("cut", settings);
  ASSERT_TRUE(cut.says("results:", patience)) << cut.output();
  wait_for(0.3);
  kill(cut.pid(), SIGINT);
  ASSERT_EQ(cut.wait(patience), 130) << cut.output();
  const std::size_t before = rows("cut");
  ASSERT_GT(before, 0U);
  ASSERT_LT(before, rows("whole"));
  Program killed = resume("cut", "killed.log");
  ASSERT_TRUE(killed.says("resumed at", patience)) << killed.output();
  while (fs::exists(folder("cut") / "results.h5.new") && killed.running()) wait_for(0.001);
  wait_for(0.1);
  kill(killed.pid(), SIGKILL);
  killed.wait(patience);
  EXPECT_GE(rows("cut"), before);
  finish("cut", "resumed.log");
  expect_same("whole", "cut");
}

TEST_F(Resume, AKillBeforeTheSecondFrameDoesNotDoubleTheFirst) {
  const std::vector<std::string> settings = {"time.end=0.1", "output.frame_interval=0.05"};
  Program whole = start("whole", settings);
  ASSERT_EQ(whole.wait(patience), 0) << whole.output();
  Program cut = start("cut", settings);
  while (!fs::exists(folder("cut") / "checkpoint") && cut.running()) wait_for(0.001);
  kill(cut.pid(), SIGKILL);
  cut.wait(patience);
  ASSERT_EQ(rows("cut"), 0U) << "the second frame was there before the kill";
  finish("cut", "resumed.log");
  expect_same("whole", "cut");
}

// A run that fails writes its rows up to the failure; its checkpoint is from the last frame. The rows
// behind that frame are computed again, and come once, also where they are nearer to it than a nanosecond.
TEST_F(Resume, WindowsShorterThanANanosecondComeOnce) {
  const std::vector<std::string> settings = {"time.end=4e-7", "time.window=4e-10",
                                             "output.frame_interval=1e-7"};
  constexpr std::size_t rows_a_frame = 250;
  Program whole = start("whole", settings);
  ASSERT_EQ(whole.wait(patience), 0) << whole.output();
  constexpr int tries = 20;  // a solver that is killed at a frame leaves no rows behind it
  for (int k = 0; k < tries && rows("cut") % rows_a_frame == 0; ++k) {
    fs::remove_all(folder("cut"));
    Program cut = start("cut", settings, false);
    while (rows("cut") < rows_a_frame && cut.running()) wait_for(0.001);
    wait_for(0.02);
    for (const auto& [pid, name] : children_of(cut.pid()))
      if (name == "solid_solver") kill(pid, SIGKILL);
    cut.wait(patience);
  }
  ASSERT_NE(rows("cut") % rows_a_frame, 0U) << "no rows behind the last frame: nothing was tested";
  finish("cut", "resumed.log");
  expect_same("whole", "cut");
}

TEST_F(Resume, AFolderInUseIsRefused) {
  Program running = start("running", {"time.end=1000", "output.frame_interval=0.01"});
  ASSERT_TRUE(running.says("results:", patience)) << running.output();
  while (!fs::exists(folder("running") / "checkpoint") && running.running()) wait_for(0.01);
  Program second = resume("running", "second.log");
  EXPECT_EQ(second.wait(patience), 1) << second.output();
  EXPECT_THAT(second.output(), HasSubstr("a run is in progress in this folder"));
  EXPECT_TRUE(running.running());
  // The lock of a run that was killed is gone with it.
  kill(running.pid(), SIGKILL);
  running.wait(patience);
  Program third = resume("running", "third.log");
  ASSERT_TRUE(third.says("resumed at", patience)) << third.output();
  Program fourth = resume("running", "fourth.log");
  EXPECT_EQ(fourth.wait(patience), 1) << fourth.output();
  EXPECT_THAT(fourth.output(), HasSubstr("a run is in progress in this folder"));
  kill(third.pid(), SIGINT);
  EXPECT_EQ(third.wait(patience), 130) << third.output();
}

TEST_F(Resume, ResultsThatDoNotReachTheCheckpointAreRefusedInWords) {
  for (const std::string& name : {std::string("long"), std::string("short")}) {
    Program cut = start(name, {"time.end=1000", "output.frame_interval=0.01"});
    const std::size_t wanted = name == "long" ? 200 : 1;  // 50 a frame
    while (rows(name) < wanted && cut.running()) wait_for(0.01);
    kill(cut.pid(), SIGINT);
    ASSERT_EQ(cut.wait(patience), 130) << cut.output();
  }
  const std::size_t longer = rows("long"), shorter = rows("short");
  ASSERT_NE(longer, shorter) << "two runs that were cut at the same window";
  const std::string less = longer < shorter ? "long" : "short", more = longer < shorter ? "short" : "long";
  fs::copy_file(folder(less) / "results.h5", folder(more) / "results.h5",
                fs::copy_options::overwrite_existing);
  Program refused = resume(more, "refused.log");
  EXPECT_EQ(refused.wait(100), 1) << refused.output();
  EXPECT_THAT(refused.output(), HasSubstr("a part of the results is missing"));
}

/// Puts a dataset of zeros in the place of another.
void replace_dataset(const fs::path& results, const std::string& name, const std::vector<hsize_t>& size) {
  H5::H5File file(results, H5F_ACC_RDWR);
  file.unlink(name);
  file.createDataSet(name, H5::PredType::NATIVE_DOUBLE,
                     H5::DataSpace(static_cast<int>(size.size()), size.data()));
}

TEST_F(Resume, ResultsOfAnotherShapeAreRefusedInWords) {
  const std::vector<std::pair<std::string, std::vector<hsize_t>>> shapes = {
      {"/history/time", {1000, 1000}},
      {"/history/time", {}},
      {"/frames/fluid/velocity", {1000}},
      {"/frames/fluid/velocity", {1000, 4, 0}}};
  Program cut = start("cut", {"time.end=1000", "output.frame_interval=0.01"});
  while (rows("cut") < 50 && cut.running()) wait_for(0.01);
  kill(cut.pid(), SIGINT);
  ASSERT_EQ(cut.wait(patience), 130) << cut.output();
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const std::string name = "shape" + std::to_string(k);
    fs::copy(folder("cut"), folder(name));
    replace_dataset(folder(name) / "results.h5", shapes[k].first, shapes[k].second);
    Program refused = resume(name, name + ".log");
    EXPECT_EQ(refused.wait(patience), 1) << refused.output();
    EXPECT_THAT(refused.output(), HasSubstr("results.h5: " + shapes[k].first)) << k;
  }
}

}  // namespace
}  // namespace cosurge::testing
