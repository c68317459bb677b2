// Maps that are interrupted and continued, or have the same output file as another map.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double patience = 300;  // s: a tenth is enough on an idle machine

class Map : public ::testing::Test {
 protected:
  std::vector<std::string> command(const std::string& end, const std::vector<std::string>& over = {}) const {
    std::vector<std::string> words = {cosurge_program,   "map",
                                      small_dam_break,   "--set",
                                      "time.end=" + end, "solid.model=modal",
                                      "--cores",         "1",
                                      "--out",           scratch_.path() / "map.csv"};
    for (const std::string& axis :
         over.empty() ? std::vector<std::string>{"solid.density=1000,1200"} : over) {
      words.push_back("--over");
      words.push_back(axis);
    }
    return words;
  }

  /// Kills a map once its first row is there, and returns the processes that it had started.
  std::vector<std::pair<pid_t, std::string>> cut(const std::vector<std::string>& words) {
    Program map(words, scratch_.path() / "cut.log");
    EXPECT_TRUE(map.says("1000, 0.002: stable", patience)) << map.output();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto children = children_of(map.pid());
    kill(map.pid(), SIGKILL);
    map.wait(patience);
    return children;
  }

  /// Runs a map to its end and returns its table.
  std::string table(const std::vector<std::string>& words) {
    Program map(words, scratch_.path() / "map.log");
    EXPECT_EQ(map.wait(patience), 0) << map.output();
    std::ostringstream text;
    text << std::ifstream(scratch_.path() / "map.csv").rdbuf();
    return text.str();
  }

  ScratchFolder scratch_;
};

/// Whether the process has ended (a zombie counts as ended).
bool ends(pid_t pid) {
  for (int k = 0; k < 100; ++k) {
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string number, name, state;
    if (!(stat >> number >> name >> state) || state == "Z") return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST_F(Map, ThatIsKilledLeavesNoCellRunning) {
  const auto children = cut(command("2", {"solid.density=1000,1200", "time.end=0.002,20"}));
  ASSERT_EQ(children.size(), 1U);
  for (const auto& [pid, name] : children) {
    EXPECT_TRUE(ends(pid));
    kill(pid, SIGKILL);
  }
}

TEST_F(Map, TakesItsOwnCellsOnly) {
  (void)cut(command("2", {"solid.density=1000,1200", "time.end=0.002,20"}));
  const fs::path cells = scratch_.path() / "map.csv.cells";
  ASSERT_TRUE(fs::exists(cells));
  // The same cells of a map with another value that is not among its axes, and another window.
  std::vector<std::string> other = command("2", {"solid.density=1000,1200", "time.end=0.002"});
  other.insert(other.begin() + 5, "time.window=1e-4");
  EXPECT_THAT(table(other), HasSubstr("1000,0.002,stable,0.002,20,"));
}

TEST_F(Map, GoesOnWhereItWasCut) {
  (void)cut(command("2", {"solid.density=1000,1200", "time.end=0.002,20"}));
  const fs::path cells = scratch_.path() / "map.csv.cells";
  int marked = 0;
  for (const auto& entry : fs::directory_iterator(cells)) {
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    std::ofstream(entry.path()) << std::regex_replace(text.str(), std::regex("stable,0.002,10,"),
                                                      "stable,0.002,kept,");
    ++marked;
  }
  EXPECT_EQ(marked, 1);
  const std::string rows = table(command("2", {"solid.density=1000,1200", "time.end=0.002"}));
  EXPECT_THAT(rows, HasSubstr("1000,0.002,stable,0.002,kept,"));
  EXPECT_THAT(rows, HasSubstr("1200,0.002,stable,0.002,10,"));
}

TEST_F(Map, IsNotDisturbedByChildrenThatItHasNotStarted) {
  std::string line = "sleep 0.05 & exec";
  for (const std::string& word : command("0.01")) line += " '" + word + "'";
  EXPECT_THAT(table({"/bin/sh", "-c", line}), HasSubstr("1200,stable,0.01,50,"));
}

TEST_F(Map, SaysWhatKilledACell) {
  Program map(command("20"), scratch_.path() / "map.log");
  for (int cell = 0; cell < 2; ++cell) {
    std::vector<std::pair<pid_t, std::string>> children;
    while ((children = children_of(map.pid())).empty() && map.running())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    for (const auto& [pid, name] : children) {
      kill(pid, SIGKILL);
      while (fs::exists("/proc/" + std::to_string(pid)))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  EXPECT_EQ(map.wait(patience), 1) << map.output();
  EXPECT_THAT(map.output(), HasSubstr("its process was killed by signal 9 (Killed)"));
}

}  // namespace
}  // namespace cosurge::testing
