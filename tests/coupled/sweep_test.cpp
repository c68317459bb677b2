// Sweeps: their tables, runs that are kept, removed or continued, plans from a file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupler/results.hpp"
#include "coupler/study/curve.hpp"
#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double patience = 300;  // s: a tenth is enough on an idle machine

using Words = std::vector<std::string>;

std::vector<Words> read_csv(const fs::path& file) {
  std::vector<Words> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) continue;
    rows.emplace_back(1);
    for (const char c : line)
      if (c == ',')
        rows.back().emplace_back();
      else
        rows.back().back() += c;
  }
  return rows;
}

class Sweep : public ::testing::Test {
 protected:
  /// Runs a sweep to its end and returns what it said.
  std::string said(const Words& more, int status = 0) const {
    Words words = {cosurge_program,     "sweep", small_dam_break, "--set", "time.end=0.06",
                   "solid.model=modal", "--out", folder()};
    words.insert(words.end(), more.begin(), more.end());
    Program sweep(words, scratch_.path() / "sweep.log");
    EXPECT_EQ(sweep.wait(patience), status) << sweep.output();
    return sweep.output();
  }

  fs::path folder() const { return scratch_.path() / "sweep"; }
  fs::path table() const { return folder() / "sweep.csv"; }

  ScratchFolder scratch_;
};

TEST_F(Sweep, TabulatesEveryProbeWithItsUnit) {
  said({"--over", "solid.young_modulus=1e6,2e7", "--keep"});
  const auto rows = read_csv(table());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0],
              ElementsAre("solid.young_modulus", "state", "core_seconds", "peak(tip.x) [m]",
                          "time_of_peak(tip.x) [s]", "peak(tip.y) [m]", "time_of_peak(tip.y) [s]",
                          "peak(foot) [Pa]", "time_of_peak(foot) [s]", "impulse(foot) [Pa s]", "reason"));
  const Results soft(folder() / "runs/solid.young_modulus=1e6");
  const Curve tip{.time = soft.history("time").values, .values = soft.history("solid/tip_x").values};
  EXPECT_EQ(rows[1][0], "1e6");
  EXPECT_EQ(rows[1][1], "finished");
  EXPECT_EQ(rows[1][3], fmt::format("{:.6g}", peak_of(tip).value));
  EXPECT_EQ(rows[1][4], fmt::format("{:.6g}", peak_of(tip).time));
  const Curve foot{.time = tip.time, .values = soft.history("fluid/foot").values};
  EXPECT_EQ(rows[1][9], fmt::format("{:.6g}", integral_of(foot)));
  EXPECT_NE(rows[1][3], rows[2][3]) << "a stiffer plate moves otherwise";
}

TEST_F(Sweep, RemovesTheRunsAndDoesNotOverwriteTheTable) {
  const Words words = {"--over", "time.window=4e-4,2e-4", "--quantity", "peak(fluid/front)"};
  EXPECT_THAT(said(words), HasSubstr("--keep keeps them"));
  EXPECT_FALSE(fs::exists(folder() / "runs"));
  EXPECT_THAT(read_csv(table())[0],
              ElementsAre("time.window", "state", "core_seconds", "peak(fluid/front) [m]", "reason"));
  EXPECT_THAT(said(words, 1), HasSubstr("holds other files; choose another --out"));
}

TEST_F(Sweep, ThatIsKilledGoesOnWithWhatIsLeft) {
  const auto over = [](const char* second) {
    return Words{"--over", std::string("time.window=4e-4,") + second, "--quantity", "peak(tip.x)"};
  };
  {
    Words words = {cosurge_program,     "sweep", small_dam_break, "--set", "time.end=0.06",
                   "solid.model=modal", "--out", folder()};
    for (const std::string& word : over("1e-6")) words.push_back(word);  // the second takes minutes
    Program sweep(words, scratch_.path() / "cut.log");
    ASSERT_TRUE(sweep.says("1/2 time.window=4e-4", patience)) << sweep.output();
    kill(sweep.pid(), SIGKILL);
    sweep.wait(patience);
  }
  EXPECT_FALSE(fs::exists(table()));
  EXPECT_THAT(said(over("2e-4")), HasSubstr("2 runs, 1 of them to do"));
  EXPECT_EQ(read_csv(table()).size(), 3U);
}

TEST_F(Sweep, TakesAPlanAndKeepsWhatFailed) {
  std::ofstream(scratch_.path() / "plan.csv") << "solid.model,time.window\nrigid,4e-4\nmodal,\n";
  const std::string plan = (scratch_.path() / "plan.csv").string();
  said({"--plan", plan, "--quantity", "peak(foot)"});
  const auto rows = read_csv(table());
  EXPECT_EQ(rows[1][0], "rigid");
  EXPECT_EQ(rows[2][1], "");
  EXPECT_EQ(rows[2][2], "finished");
  fs::remove_all(folder());
  // Water that leaves through the open side at once: the run fails, and its reason is in the table.
  const std::string output = said({"--over", "fluid.most_lost=0,0.5", "--set", "gravity=[-300,9.81]"}, 1);
  EXPECT_THAT(output, HasSubstr("some runs failed"));
  EXPECT_TRUE(fs::exists(folder() / "runs"));
  EXPECT_EQ(read_csv(table())[1][1], "failed");
  EXPECT_NE(read_csv(table())[1].back(), "");
}

TEST_F(Sweep, RefusesAllThatIsWrongAtOnce) {
  const std::string output =
      said({"--over", "time.window=-1,2e-4", "--quantity", "peak(top.x)", "mean(tip.x)"}, 1);
  for (const char* words : {"time.window", "no column top.x", "mean(tip.x): must be"})
    EXPECT_THAT(output, HasSubstr(words));
  EXPECT_FALSE(fs::exists(folder()));
}

}  // namespace
}  // namespace cosurge::testing
