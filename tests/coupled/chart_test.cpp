// Charts that are interrupted and continued, and plans that are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double patience = 300;  // s: a tenth is enough on an idle machine

class Chart : public ::testing::Test {
 protected:
  using Words = std::vector<std::string>;

  Words command(const Words& windows, const Words& more = {"--quantity", "peak(tip.x)"}) const {
    Words words = {
        cosurge_program,     "chart", small_dam_break,           "--set",  "time.end=0.1",
        "solid.model=modal", "--out", scratch_.path() / "chart", "--over", "time.window=" + windows.front()};
    for (std::size_t k = 1; k < windows.size(); ++k) words.back() += "," + windows[k];
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  /// Runs a chart to its end and returns its output.
  std::string said(const Words& words, int status = 0) const {
    Program chart(words, scratch_.path() / "chart.log");
    EXPECT_EQ(chart.wait(patience), status) << chart.output();
    return chart.output();
  }

  std::string table() const {
    std::ostringstream text;
    text << std::ifstream(scratch_.path() / "chart/chart.csv").rdbuf();
    return text.str();
  }

  /// When the results of each run were last written.
  std::map<std::string, fs::file_time_type> results() const {
    std::map<std::string, fs::file_time_type> found;
    for (const auto& entry : fs::directory_iterator(scratch_.path() / "chart/runs"))
      if (fs::exists(entry.path() / "results.h5"))
        found[entry.path().filename()] = fs::last_write_time(entry.path() / "results.h5");
    return found;
  }

  ScratchFolder scratch_;
};

TEST_F(Chart, ThatIsKilledGoesOnWithWhatIsLeft) {
  const Words words = command({"4e-4", "1e-5", "none"});  // the second takes minutes
  {
    Program chart(words, scratch_.path() / "cut.log");
    ASSERT_TRUE(chart.says("1/3 time.window=4e-4", patience)) << chart.output();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    kill(chart.pid(), SIGKILL);
    chart.wait(patience);
    EXPECT_THAT(chart.output(), Not(HasSubstr("2/3")));
  }
  EXPECT_FALSE(fs::exists(scratch_.path() / "chart/chart.csv"));
  const auto before = results();
  ASSERT_TRUE(before.contains("time.window=4e-4"));
  const std::string output = said(command({"4e-4", "2e-4", "none"}));
  EXPECT_THAT(output, HasSubstr("3 runs, 2 of them to do"));
  EXPECT_EQ(results().at("time.window=4e-4"), before.at("time.window=4e-4"));
  EXPECT_THAT(table(), HasSubstr("\n4e-4,finished,"));
  EXPECT_THAT(table(), HasSubstr("\n2e-4,truth,"));  // the most expensive of the three
}

TEST_F(Chart, TakesRunsOfItsOwnSettingsOnly) {
  EXPECT_THAT(said(command({"4e-4", "2e-4"})), HasSubstr("2 runs, 2 of them to do"));
  const std::string first = table();
  // Another quantity needs no run; another value outside the plan needs all runs.
  EXPECT_THAT(said(command({"4e-4", "2e-4"}, {"--quantity", "impulse(foot)", "--truth", "impulse(foot)=1"})),
              HasSubstr("2 runs, 0 of them to do"));
  EXPECT_THAT(table(), HasSubstr("impulse(foot) [Pa s]"));
  Words other = command({"4e-4", "2e-4"});
  other.insert(other.begin() + 6, "solid.density=1000");
  EXPECT_THAT(said(other), HasSubstr("2 runs, 2 of them to do"));
  EXPECT_NE(table(), first);
}

TEST_F(Chart, RefusesAWrongPlanAtOnceAndWritesNothing) {
  const std::string output = said(
      command({"-1", "2e-4"}, {"--quantity", "peak(top.x)", "mean(tip.x)", "--truth", "nowhere.csv"}), 1);
  for (const char* words : {"time.window", "no column top.x", "mean(tip.x): must be"})
    EXPECT_THAT(output, HasSubstr(words));
  EXPECT_FALSE(fs::exists(scratch_.path() / "chart"));
}

TEST_F(Chart, LeavesAFolderWithOtherFilesAlone) {
  fs::create_directory(scratch_.path() / "chart");
  std::ofstream(scratch_.path() / "chart/notes.txt") << "mine";
  EXPECT_THAT(said(command({"4e-4", "2e-4"}), 1), HasSubstr("holds other files; choose another --out"));
  EXPECT_FALSE(fs::exists(scratch_.path() / "chart/runs"));
}

}  // namespace
}  // namespace cosurge::testing
