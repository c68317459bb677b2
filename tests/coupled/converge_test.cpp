// cosurge converge: what it predicts, runs and refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double patience = 300;  // s: a tenth is enough on an idle machine

using Words = std::vector<std::string>;

class Converge : public ::testing::Test {
 protected:
  /// A collapse of 18 spacings at its width: less than a second each.
  std::string said(const Words& more, int status) const {
    Words words = {cosurge_program,
                   "converge",
                   small_dam_break,
                   "--set",
                   "time.end=0.1",
                   "fluid.spacing=0.004",
                   "time.window=none",
                   "solid=none",
                   "coupling=none",
                   "output.probe=[{name='foot',quantity='pressure',position=[0.02,0.0]}]",
                   "--out",
                   folder()};
    words.insert(words.end(), more.begin(), more.end());
    Program converge(words, scratch_.path() / "converge.log");
    EXPECT_EQ(converge.wait(patience), status) << converge.output();
    return converge.output();
  }

  /// Runs in the table: one a line, after the command and the heads.
  std::size_t rows() const {
    std::ifstream in(folder() / "converge.csv");
    std::size_t lines = 0;
    for (std::string line; std::getline(in, line);) ++lines;
    return lines < 2 ? 0 : lines - 2;
  }

  fs::path folder() const { return scratch_.path() / "converge"; }

  ScratchFolder scratch_;
};

TEST_F(Converge, RunsTheSpacingThatABudgetAllows) {
  // The front: an integral of the whole flow, which hardly scatters.
  const std::string text = said({"--quantity", "peak(fluid/front, 0..0.1)", "--budget", "4s"}, 0);
  EXPECT_THAT(text, AllOf(HasSubstr("expected with"), HasSubstr("error"), HasSubstr("computed with"),
                          HasSubstr("of the expected"), HasSubstr("for a spacing of zero")));
  EXPECT_GE(rows(), 7U) << "coarse spacings from two starts, and the chosen one";
  // Everything is there: the same command computes nothing.
  EXPECT_THAT(said({"--quantity", "peak(fluid/front, 0..0.1)", "--budget", "4s"}, 0),
              AllOf(HasSubstr("2 runs, 0 of them to do"), HasSubstr("1 runs, 0 of them to do")));
}

TEST_F(Converge, TakesACoarseRunThatIsAccurateEnough) {
  const std::string text = said({"--quantity", "peak(fluid/front, 0..0.1)", "--accuracy", "50%"}, 0);
  EXPECT_THAT(text, Not(HasSubstr("1 runs")));
  EXPECT_EQ(rows(), 6U);
}

TEST_F(Converge, RefusesAnAccuracyBeyondTheBudgetAndSaysWhatItAllows) {
  const std::string text = said(
      {"--quantity", "impulse(foot)", "peak(fluid/front)", "--accuracy", "0.0001%", "--budget", "5s"}, 1);
  EXPECT_THAT(text, ::testing::AnyOf(HasSubstr("beyond the budget of 5 s, which allows"),
                                     HasSubstr("more than the accuracy of")));
}

TEST_F(Converge, NamesEveryWrongOptionBeforeTheFirstRun) {
  EXPECT_THAT(said({"--quantity", "peak(foot)"}, 1), HasSubstr("--accuracy or --budget is missing"));
  EXPECT_THAT(said({"--quantity", "peak(foot)", "--accuracy", "2 mm", "--budget", "10"}, 1),
              AllOf(HasSubstr("--accuracy 2 mm: must be a relative error"),
                    HasSubstr("--budget 10: must be a time with its unit")));
  EXPECT_THAT(said({"--quantity", "rms(foot)", "peak(nothing)", "--accuracy", "2%"}, 1),
              AllOf(HasSubstr("rms(foot): needs a true history"), HasSubstr("nothing")));
  EXPECT_FALSE(fs::exists(folder()));
}

}  // namespace
}  // namespace cosurge::testing
