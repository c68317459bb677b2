// Runs on a disk that is full, broken, or whose machine dies, at any write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string failing_disk = FAILING_DISK;
constexpr double patience = 300;  // s: a tenth is enough on an idle machine

class FailingDisk : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    H5::Exception::dontPrint();
    scratch = std::make_unique<ScratchFolder>();
    Program program = run("whole", "/whole/", 0, 0);
    ASSERT_EQ(program.wait(patience), 0) << program.output();
    whole = physics(read_results(scratch->path() / "whole"));
    std::ifstream(scratch->path() / "whole.count") >> writes;
    ASSERT_GT(writes, 100);
    ASSERT_EQ(whole.at("/frames/time").size(), 6U);
  }

  static void TearDownTestSuite() { scratch.reset(); }

  /// The small dam break in one process. Write number `at` to files whose path contains `word` fails with
  /// `error`, or kills the program if `error` is 0.
  static Program run(const std::string& name, const std::string& word, long at, int error) {
    return program(name, word, at, error,
                   {"run", small_dam_break, "--out", scratch->path() / name, "--set", "time.end=0.01",
                    "output.frame_interval=0.002"});
  }

  static Program resume(const std::string& name, long at = 0, int error = 0) {
    return program(name, "/" + name + "/", at, error, {"resume", scratch->path() / name});
  }

  /// Checks that the results can be read and are correct.
  static void expect_part_of_whole(const std::string& name) {
    const Datasets part = physics(read_results(scratch->path() / name));
    for (const auto& [place, values] : part) {
      ASSERT_TRUE(whole.contains(place)) << place;
      const std::vector<double>& all = whole.at(place);
      ASSERT_LE(values.size(), all.size()) << place;
      EXPECT_EQ(std::memcmp(values.data(), all.data(), sizeof(double) * values.size()), 0) << place;
    }
  }

  static void expect_whole(const std::string& name) {
    expect_part_of_whole(name);
    const Datasets all = physics(read_results(scratch->path() / name));
    ASSERT_EQ(all.size(), whole.size());
    for (const auto& [place, values] : all) EXPECT_EQ(values.size(), whole.at(place).size()) << place;
    EXPECT_EQ(read_summary(scratch->path() / name).at("status"), "finished");
  }

  static std::unique_ptr<ScratchFolder> scratch;
  static Datasets whole;
  static long writes;

 private:
  static Program program(const std::string& name, const std::string& word, long at, int error,
                         const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {
        "/usr/bin/env",
        "LD_PRELOAD=" + failing_disk,
        "FAILING_DISK_PATH=" + word,
        "FAILING_DISK_AT=" + std::to_string(at),
        "FAILING_DISK_ERROR=" + std::to_string(error),
        "FAILING_DISK_COUNT=" + (scratch->path() / (name + ".count")).string(),
        cosurge_program};
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.begin() + 8, {"--in-process", "--threads", "1"});
    return Program(command, scratch->path() / (name + ".log"));
  }
};

std::unique_ptr<ScratchFolder> FailingDisk::scratch;
Datasets FailingDisk::whole;
long FailingDisk::writes = 0;

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  const std::size_t begin = text.rfind('\n', end);
  return text.substr(begin + 1, end - begin);
}

TEST_F(FailingDisk, EndsTheRunInWordsKeepsTheResultsAndLetsItGoOn) {
  int resumed = 0;
  for (const int error : {ENOSPC, EIO}) {
    for (long at = 1; at <= writes; at += writes / 23) {
      SCOPED_TRACE(fmt::format("{} at write {} of {}", std::strerror(error), at, writes));
      const std::string name = fmt::format("full_{}_{}", error, at);
      Program cut = run(name, "/" + name + "/", at, error);
      ASSERT_EQ(cut.wait(patience), 1) << cut.output();
      EXPECT_THAT(cut.output(), HasSubstr(std::strerror(error)));
      if (!fs::exists(scratch->path() / name / "checkpoint")) continue;
      EXPECT_THAT(last_line(cut.output()), HasSubstr("to resume: cosurge resume"));
      EXPECT_THAT(cut.output(), HasSubstr("failed at t = "));
      expect_part_of_whole(name);
      Program full = resume(name, 3, error);  // there is still no room
      EXPECT_EQ(full.wait(patience), 1) << full.output();
      EXPECT_THAT(full.output(), HasSubstr(std::strerror(error)));
      Program again = resume(name);
      ASSERT_EQ(again.wait(patience), 0) << again.output();
      expect_whole(name);
      ++resumed;
    }
  }
  EXPECT_GT(resumed, 20);
}

TEST_F(FailingDisk, AKillAtAnyWriteLeavesRightResultsThatCanBeResumed) {
  int resumed = 0;
  for (long at = 1; at <= writes; at += 29) {
    SCOPED_TRACE(fmt::format("killed at write {} of {}", at, writes));
    const std::string name = fmt::format("killed_{}", at);
    Program cut = run(name, "/" + name + "/", at, 0);
    ASSERT_EQ(cut.wait(patience), 128 + SIGKILL) << cut.output();
    if (!fs::exists(scratch->path() / name / "checkpoint")) continue;
    expect_part_of_whole(name);
    Program again = resume(name);
    const bool done = again.wait(patience) == 1 && again.output().find("is finished") != std::string::npos;
    ASSERT_TRUE(done || again.wait(patience) == 0) << again.output();
    expect_whole(name);
    ++resumed;
  }
  EXPECT_GT(resumed, 20);
}

}  // namespace
}  // namespace cosurge::testing
