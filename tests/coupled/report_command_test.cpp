// The commands that make pages, as a user calls them. What the pages show is tested in a browser
// (tests/browser).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double patience = 600;  // s: with sanitizers, on a busy machine

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The data of the page.
nlohmann::json document_of(const fs::path& page) {
  const std::string text = text_of(page), begin = "<script type=\"application/json\" id=\"document\">";
  const std::size_t at = text.find(begin) + begin.size();
  return nlohmann::json::parse(text.substr(at, text.find("</script>", at) - at));
}

struct Said {
  int status;
  std::string output;
};

Said cosurge_says(const ScratchFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), cosurge_program);
  Program program(arguments, folder.path() / "said");
  const int status = program.wait(patience);
  return {status, program.output()};
}

TEST(ReportCommand, WritesTheRunsPeaksAndReplacesOnlyItsOwnPage) {
  const ScratchFolder folder;
  const std::string run = (folder.path() / "run").string(), other = (folder.path() / "other.html").string();
  // With weak coupling the spurious work of this coarse case scatters around the limit of a good result.
  ASSERT_EQ(cosurge_says(folder, {"run", small_dam_break, "--out", run, "--set", "time.end=0.1",
                                  "coupling.scheme=strong"})
                .status,
            0);
  for (int times = 0; times < 2; ++times) {
    const Said said = cosurge_says(folder, {"report", run});
    EXPECT_EQ(said.status, 0) << said.output;
    EXPECT_THAT(said.output, HasSubstr(run + "/report.html"));
  }
  const nlohmann::json document = document_of(fs::path(run) / "report.html")["runs"][0];
  const nlohmann::json summary = read_summary(run);
  bool found = false;
  for (const auto& row : document["extremes"])
    if (row["name"] == "solid/tip_x") {
      found = true;
      EXPECT_EQ(row["peak"], summary["probes"]["tip_x"]["peak"]["value"]);
      EXPECT_EQ(row["peak_time"], summary["probes"]["tip_x"]["peak"]["time"]);
    }
  EXPECT_TRUE(found);
  EXPECT_EQ(document["verdict"]["level"], "good") << document["verdict"];
  EXPECT_EQ(document["scene"]["times"].size(), 6U);  // every 0.02 s
  EXPECT_THAT(document["facts"].dump(), HasSubstr("--set time.end=0.1"));
  std::ofstream(other) << "somebody's";
  const Said refused =
      cosurge_says(folder, {"report", run, run + "/nowhere", "--out", other, "--case", "/nowhere"});
  EXPECT_EQ(refused.status, 1);
  for (const std::string part :
       {"other.html: exists already", "/nowhere: no such folder", "nowhere: contains no results"})
    EXPECT_THAT(refused.output, HasSubstr(part)) << "all at once";
  EXPECT_EQ(text_of(other), "somebody's");
}

TEST(CheckCommand, DrawsThePictureOfACaseAndWritesNothingOver) {
  const ScratchFolder folder;
  const std::string page = (folder.path() / "case.html").string();
  const Said said = cosurge_says(folder, {"check", small_dam_break, "--picture", page});
  EXPECT_EQ(said.status, 0) << said.output;
  const nlohmann::json scene = document_of(page)["runs"][0]["scene"];
  EXPECT_EQ(scene["chunks"][1]["particles"], 30);  // the plate's
  std::vector<std::string> kinds;
  for (const auto& part : scene["outlines"]) kinds.push_back(part["kind"]);
  EXPECT_THAT(kinds, ::testing::ElementsAre("tank", "water", "body", "clamp", "probe", "probe"));
  const std::string before = text_of(page);
  const Said again = cosurge_says(folder, {"check", small_dam_break, "--picture", page});
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.output, HasSubstr("exists already"));
  EXPECT_EQ(text_of(page), before);
}

TEST(WatchCommand, EndsAtASignalAndSaysWhatIsWrongFirst) {
  const ScratchFolder folder;
  EXPECT_EQ(cosurge_says(folder, {"watch", (folder.path() / "nowhere").string()}).status, 1);
  const std::string run = (folder.path() / "run").string();
  ASSERT_EQ(cosurge_says(folder, {"run", small_dam_break, "--out", run, "--set", "time.end=0.01"}).status, 0);
  Program watch({cosurge_program, "watch", run}, folder.path() / "said");
  EXPECT_TRUE(watch.says("http://127.0.0.1:", patience)) << watch.output();
  kill(watch.pid(), SIGINT);
  EXPECT_EQ(watch.wait(30), 0);
}

}  // namespace
}  // namespace cosurge::testing
