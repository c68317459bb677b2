// Resumption from a damaged checkpoint, or from one of another program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double patience = 300;  // s: a tenth is enough on an idle machine

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void write(const fs::path& path, const std::string& bytes) {
  fs::remove(path);  // the two checkpoints must not become one
  std::ofstream(path, std::ios::binary) << bytes;
}

class Checkpoints : public ::testing::Test {
 protected:
  /// A run that was stopped at its last but one frame, with its two checkpoints; and an uninterrupted run.
  void SetUp() override {
    H5::Exception::dontPrint();
    Program run({cosurge_program, "run", small_dam_break, "--in-process", "--threads", "1", "--out", whole_,
                 "--set", "time.end=0.008", "output.frame_interval=0.002"},
                scratch_.path() / "whole.log");
    while (!fs::exists(whole_ / "checkpoint.old") && run.running())
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    kill(run.pid(), SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    fs::copy(whole_, cut_);
    kill(run.pid(), SIGCONT);
    ASSERT_EQ(run.wait(patience), 0) << run.output();
    fs::remove(cut_ / "checkpoint.new");
    last_ = bytes_of(cut_ / "checkpoint");
    before_ = bytes_of(cut_ / "checkpoint.old");
    ASSERT_NE(last_, before_);
  }

  /// A resumption of a copy of the run, with these checkpoints.
  Program resume(const std::string& last, const std::string& before, std::vector<std::string> more = {}) {
    fs::remove_all(tried_);
    fs::copy(cut_, tried_);
    write(tried_ / "checkpoint", last);
    write(tried_ / "checkpoint.old", before);
    std::vector<std::string> command = {cosurge_program, "resume", tried_, "--threads", "1"};
    if (more.empty()) more = {"--in-process"};
    command.insert(command.end(), more.begin(), more.end());
    return Program(command, scratch_.path() / "tried.log");
  }

  void expect_the_results_of_the_whole_run() {
    const Datasets a = physics(read_results(whole_)), b = physics(read_results(tried_));
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [name, values] : a) {
      ASSERT_EQ(values.size(), b.at(name).size()) << name;
      EXPECT_EQ(std::memcmp(values.data(), b.at(name).data(), sizeof(double) * values.size()), 0) << name;
    }
  }

  ScratchFolder scratch_;
  fs::path whole_ = scratch_.path() / "whole", cut_ = scratch_.path() / "cut",
           tried_ = scratch_.path() / "tried";
  std::string last_, before_;
};

TEST_F(Checkpoints, WithAFlippedBitGiveWayToTheOneBefore) {
  std::mt19937 random(7);
  const auto flipped = [&](std::string bytes, std::size_t at) {
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
    return bytes;
  };
  for (int k = 0; k < 120; ++k) {
    // Half of them where the lengths and the case are.
    const std::size_t at = random() % (k % 2 == 0 ? last_.size() : 3000);
    SCOPED_TRACE(fmt::format("byte {} of {}", at, last_.size()));
    const std::string damaged = flipped(last_, at);
    if (k % 10 == 0) {  // the other times the message is enough: it comes from the same check
      Program program = resume(damaged, before_);
      ASSERT_EQ(program.wait(patience), 0) << program.output();
      EXPECT_THAT(program.output(), HasSubstr("the previous checkpoint is used"));
      expect_the_results_of_the_whole_run();
    }
    Program refused = resume(damaged, flipped(before_, at % before_.size()));
    ASSERT_EQ(refused.wait(patience), 1) << refused.output();
    EXPECT_THAT(refused.output(), HasSubstr("damaged"));
  }
}

TEST_F(Checkpoints, ThatAreCutShortGiveWayToo) {
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, std::size_t{40}, last_.size() - 1}) {
    Program program = resume(last_.substr(0, length), before_);
    ASSERT_EQ(program.wait(patience), 0) << program.output();
    EXPECT_THAT(program.output(), HasSubstr("the previous checkpoint is used"));
    expect_the_results_of_the_whole_run();
  }
}

TEST_F(Checkpoints, AreForTheProgramThatWroteThem) {
  Program foreign = resume(last_, before_, {"--solid", COSURGE_SOURCE_DIR "/cases/foreign_solid/plate.py"});
  EXPECT_EQ(foreign.wait(patience), 1) << foreign.output();
  EXPECT_THAT(foreign.output(),
              HasSubstr("the state of the solid in the checkpoint was written by solid_solver"));
  Program own = resume(last_, before_);
  EXPECT_EQ(own.wait(patience), 0) << own.output();
  EXPECT_EQ(own.output().find("warning"), std::string::npos) << own.output();
  expect_the_results_of_the_whole_run();
}

// Another build has another build ID.
TEST_F(Checkpoints, OfAnotherBuildComeWithAWarning) {
  const fs::path other = scratch_.path() / "bin/cosurge", library = scratch_.path() / "lib" / COSURGE_SONAME;
  fs::create_directories(other.parent_path());
  fs::create_directories(library.parent_path());
  fs::copy(cosurge_program, other);  // which looks for the library in ../lib
  std::string code = bytes_of(fs::path(COSURGE_PROGRAMS) / "../lib" / COSURGE_SONAME);
  const std::size_t note = code.find(std::string("\x14\0\0\0\x03\0\0\0GNU\0", 12));  // 20 bytes, build id
  ASSERT_NE(note, std::string::npos);
  code[note + 12] = static_cast<char>(code[note + 12] ^ 1);
  write(library, code);
  fs::copy(cut_, tried_);
  Program resumed({other, "resume", tried_, "--in-process", "--threads", "1"}, scratch_.path() / "other.log");
  EXPECT_EQ(resumed.wait(patience), 0) << resumed.output();
  EXPECT_THAT(resumed.output(), HasSubstr("was written by another build of cosurge"));
}

}  // namespace
}  // namespace cosurge::testing
