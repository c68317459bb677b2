#include "coupler/recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "coupler/replace_file.hpp"
#include "coupler/summary.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ScratchFolder;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t water_particles = 70000;  // more than a chunk holds

v1::Case recorded_case() {
  v1::Case the_case = testing::piston_case();
  auto* tip = the_case.mutable_output()->add_probe();
  tip->set_name("tip");
  tip->set_quantity(v1::Probe::displacement);
  auto* gauge = the_case.mutable_output()->add_probe();
  gauge->set_name("P01");
  gauge->set_quantity(v1::Probe::pressure);
  return the_case;
}

std::vector<Member> recorded_members() {
  return {{.name = "fluid",
           .identity = {.program = "mock_fluid", .version = "1.2.3", .dimensions = {2}, .capabilities = {}},
           .setup = {.columns = {{"lost", "-"}, {"seconds_solve", "s"}, {"cpu_seconds", "s"}, {"P01", "Pa"}},
                     .particles = water_particles}},
          {.name = "solid",
           .identity = {.program = "mock_solid", .version = "1.2.3", .dimensions = {2}, .capabilities = {}},
           .setup = {.columns = {{"substeps", "-"}, {"interface_work", "J"}, {"tip_x", "m"}, {"tip_y", "m"}},
                     .particles = 3}}};
}

Interface recorded_interface() {
  return {.dimension = 2,
          .position = Field{{0, 1, 2}, {5, 6, 7}},
          .area = Field::Constant(2, 3, 0.5),
          .body = {0, 0, 1}};
}

/// Frame number k: every value tells particle, component and frame.
std::vector<Snapshot> snapshots(int k) {
  const auto fill = [k](const char* name, std::size_t particles, int components) {
    Array array{.name = name, .unit = "m", .components = components, .values = {}};
    for (std::size_t v = 0; v < particles * static_cast<std::size_t>(components); ++v)
      array.values.push_back(static_cast<float>(v) + 0.25F * static_cast<float>(k));
    return array;
  };
  return {{fill("position", water_particles, 2), fill("pressure", water_particles, 1)},
          {fill("solid_position", 3, 2), fill("solid_velocity", 3, 2)}};
}

/// A run of which a part is recorded.
struct RecordedRun {
  ScratchFolder folder;
  std::optional<Recorder> recorder{std::in_place,        folder.path(),
                                   recorded_case(),      recorded_members(),
                                   recorded_interface(), std::vector<Column>{{"work_points", "J"}}};
  std::uint64_t windows = 0;

  /// Ends the recording: a process opens a file only once at a time.
  fs::path close() {
    recorder.reset();
    return folder.path() / "results.h5";
  }

  /// One window of 0.5 s.
  void window(double pressure = 1, double tip = 0) {
    const double n = static_cast<double>(++windows);
    recorder->window(
        {.index = windows, .start = 0.5 * (n - 1), .size = 0.5},
        {{.values = {n, 2 * n, 3 * n, pressure}, .window = 1}, {.values = {10, n, tip, -tip}, .window = 1}},
        {4 * n});
  }
};

template <typename Number>
std::vector<Number> read(const H5::H5File& file, const std::string& name, const H5::DataType& type) {
  const H5::DataSet dataset = file.openDataSet(name);
  std::vector<Number> values(static_cast<std::size_t>(dataset.getSpace().getSimpleExtentNpoints()));
  dataset.read(values.data(), type);
  return values;
}

std::vector<double> read_series(const H5::H5File& file, const std::string& name) {
  return read<double>(file, name, H5::PredType::NATIVE_DOUBLE);
}

std::string text_of(const H5::H5Object& object, const std::string& name) {
  const H5::Attribute attribute = object.openAttribute(name);
  std::string text;
  attribute.read(attribute.getDataType(), text);
  return text;
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Checks that the file holds exactly `frames` frames of snapshots(0, 1, ...) .
void expect_frames(const fs::path& path, std::size_t frames) {
  const H5::H5File file(path.string(), H5F_ACC_RDONLY);
  EXPECT_EQ(read_series(file, "/frames/time").size(), frames);
  for (const auto& [name, m, a] : {std::tuple("/frames/fluid/position", 0, 0),
                                   {"/frames/fluid/pressure", 0, 1},
                                   {"/frames/solid/position", 1, 0},
                                   {"/frames/solid/velocity", 1, 1}}) {
    std::vector<float> expected;
    for (std::size_t k = 0; k < frames; ++k) {
      const auto values = snapshots(static_cast<int>(k))[m][a].values;
      expected.insert(expected.end(), values.begin(), values.end());
    }
    EXPECT_TRUE(read<float>(file, name, H5::PredType::NATIVE_FLOAT) == expected) << name;
  }
}

TEST(Recorder, EveryWindowIsARowOfEveryHistory) {
  RecordedRun run;
  run.window(100, 0.1);
  run.window(200, nan);
  run.recorder->flush();
  const H5::H5File file(run.close().string(), H5F_ACC_RDONLY);
  EXPECT_THAT(read_series(file, "/history/time"), ElementsAre(0.5, 1.0));
  EXPECT_THAT(read_series(file, "/history/window"), ElementsAre(0.5, 0.5));
  EXPECT_THAT(read_series(file, "/history/fluid/P01"), ElementsAre(100, 200));
  EXPECT_THAT(read_series(file, "/history/solid/tip_x"), ElementsAre(0.1, ::testing::IsNan()));
  EXPECT_THAT(read_series(file, "/history/coupling/work_points"), ElementsAre(4, 8));
  EXPECT_EQ(text_of(file.openDataSet("/history/fluid/P01"), "unit"), "Pa");
}

TEST(Recorder, FramesComeBackAsTheyWereGiven) {
  RecordedRun run;
  for (int k = 0; k < 3; ++k) run.recorder->frame(0.1 * k, snapshots(k));
  expect_frames(run.close(), 3);
}

TEST(Recorder, TheFileSaysWhatRanAndWhere) {
  RecordedRun run;
  const H5::H5File file(run.close().string(), H5F_ACC_RDONLY);
  EXPECT_EQ(text_of(file, "title"), "piston");
  EXPECT_EQ(text_of(file, "fluid"), "mock_fluid 1.2.3");
  const auto the_case = nlohmann::json::parse(text_of(file, "case"));
  EXPECT_EQ(the_case["output"]["probe"][1]["name"], "P01");
  EXPECT_THAT(read_series(file, "/interface/position"), ElementsAre(0, 5, 1, 6, 2, 7));  // a point a row
  EXPECT_THAT(read<int>(file, "/interface/body", H5::PredType::NATIVE_INT), ElementsAre(0, 0, 1));
}

TEST(Recorder, OldResultsAreNotOverwritten) {
  RecordedRun run;
  try {
    Recorder(run.folder.path(), recorded_case(), recorded_members(), recorded_interface(), {});
    FAIL() << "the second recorder took the first one's file";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("exists already"));
  }
}

TEST(Recorder, AFolderThatIsNotThereIsNamed) {
  try {
    Recorder("/nowhere", recorded_case(), recorded_members(), recorded_interface(), {});
    FAIL() << "results were written nowhere";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/results.h5: cannot be created: No such file or directory"));
  }
}

TEST(Recorder, AFrameOfAnotherLengthIsRefused) {
  RecordedRun run;
  run.recorder->frame(0, snapshots(0));
  auto shorter = snapshots(1);
  shorter[0][1].values.pop_back();
  EXPECT_THROW(run.recorder->frame(0.1, shorter), Error);
}

TEST(Recorder, AFrameOfOtherArraysIsRefusedAndNothingOfItIsWritten) {
  RecordedRun run;
  run.recorder->frame(0, snapshots(0));
  for (const std::string change : {"more", "fewer", "other", "components", "twice"}) {
    auto frame = snapshots(1);
    Snapshot& arrays = frame[0];
    if (change == "more") arrays.push_back({.name = "fluid_new", .unit = "", .components = 1, .values = {1}});
    if (change == "fewer") arrays.pop_back();
    if (change == "other") arrays[1].name = "fluid_other";
    if (change == "components") arrays[1].components = 2;
    if (change == "twice") arrays[1].name = arrays[0].name;
    EXPECT_THROW(run.recorder->frame(0.1, frame), Error) << change;
  }
  auto turned = snapshots(1);
  std::swap(turned[0][0], turned[0][1]);
  run.recorder->frame(0.1, turned);
  expect_frames(run.close(), 2);
}

TEST(Recorder, AnotherProcessReadsWhileTheRunGoesOnAndAfterItWasKilled) {
  ScratchFolder folder;
  int told[2];
  ASSERT_EQ(::pipe(told), 0);
  const pid_t writer = ::fork();
  if (writer == 0) {
    Recorder recorder(folder.path(), recorded_case(), recorded_members(), recorded_interface(), {});
    for (int k = 0; k < 3; ++k) {
      const double t = 0.5 * k;
      recorder.window({.index = 0, .start = t, .size = 0.5},
                      {{.values = {0, 0, 0, t}, .window = 1}, {.values = {1, 0, 0, 0}, .window = 1}}, {});
      recorder.frame(t + 0.5, snapshots(k));
    }
    recorder.window({.index = 3, .start = 1.5, .size = 0.5},
                    {{.values = {0, 0, 0, 0}, .window = 1}, {.values = {1, 0, 0, 0}, .window = 1}}, {});
    [[maybe_unused]] const auto written = ::write(told[1], "!", 1);
    ::pause();
    ::_exit(0);
  }
  char word = 0;
  ::close(told[1]);
  ASSERT_EQ(::read(told[0], &word, 1), 1);
  const fs::path path = folder.path() / "results.h5";
  expect_frames(path, 3);

  ::kill(writer, SIGKILL);
  int status = 0;
  ASSERT_EQ(::waitpid(writer, &status, 0), writer);
  ASSERT_TRUE(WIFSIGNALED(status));
  expect_frames(path, 3);
  EXPECT_THAT(read_series(H5::H5File(path.string(), H5F_ACC_RDONLY), "/history/fluid/P01"),
              ElementsAre(0, 0.5, 1));
}

TEST(Xdmf, EveryFrameIsAGridThatSelectsItsPartOfTheArrays) {
  RecordedRun run;
  for (int k = 0; k < 3; ++k) run.recorder->frame(0.1 * k, snapshots(k));
  const std::string text = text_of(run.folder.path() / "results.xdmf");
  EXPECT_THAT(text, HasSubstr("<Time Value=\"0.2"));
  EXPECT_THAT(text,
              HasSubstr(">results.h5:/frames/fluid/position|2 0 0:1 1 1:1 70000 2:3 70000 2</DataItem>"));
  EXPECT_THAT(text, HasSubstr("results.h5:/frames/solid/velocity"));
  EXPECT_THAT(text, HasSubstr("results.h5:/mesh/fluid"));
  EXPECT_FALSE(fs::exists(run.folder.path() / "results.xdmf.new"));
}

TEST(Xdmf, IsRarelyWrittenWhereFramesAreManyAndWholeAfterAFlush) {
  const ScratchFolder folder;
  std::vector<Member> members = {recorded_members().back()};  // three particles
  Recorder recorder(folder.path(), recorded_case(), members, recorded_interface(), {});
  const fs::path file = folder.path() / "results.xdmf";
  constexpr int frames = 2000;
  int writings = 0;
  auto seen = fs::file_time_type::min();
  for (int k = 0; k < frames; ++k) {
    recorder.frame(0.1 * k, {snapshots(k).back()});
    if (const auto now = fs::last_write_time(file); now != seen) ++writings, seen = now;
  }
  const auto grids = [&] {
    const std::string text = text_of(file);
    int count = 0;
    for (auto at = text.find("<Time"); at != std::string::npos; at = text.find("<Time", at + 1)) ++count;
    return count;
  };
  EXPECT_LT(writings, frames / 2);  // the first hundred, and a fiftieth of the time
  recorder.flush();
  EXPECT_EQ(grids(), frames);
}

TEST(Xdmf, ACloudWithoutPositionsIsLeftOut) {
  const std::string text =
      xdmf("results.h5", {0}, {{.name = "fluid", .arrays = {{"pressure", "/frames/fluid/pressure", 4, 1}}}});
  EXPECT_THAT(text, Not(HasSubstr("Collection")));
}

TEST(Summary, TellsPeaksWithTheirTimesAndTotals) {
  RecordedRun run;
  run.window(100, 0.1);
  run.window(300, -0.4);
  run.window(200, nan);
  write_summary(run.folder.path(), *run.recorder,
                {.status = "failed", .reason = "fluid: broke down", .exchange_seconds = 1.5});
  const auto summary = nlohmann::json::parse(text_of(run.folder.path() / "summary.json"));
  EXPECT_EQ(summary["status"], "failed");
  EXPECT_EQ(summary["reason"], "fluid: broke down");
  EXPECT_EQ(summary["end_time"], 1.5);
  EXPECT_EQ(summary["windows"], 3);
  EXPECT_EQ(summary["exchange_seconds"], 1.5);
  EXPECT_EQ(summary["participants"]["solid"]["steps"], 30);
  EXPECT_EQ(summary["participants"]["fluid"]["lost"], 3);
  EXPECT_EQ(summary["participants"]["fluid"]["seconds"]["phases"]["solve"], 6);
  EXPECT_EQ(summary["probes"]["P01"]["peak"], nlohmann::json({{"value", 300}, {"time", 1}}));
  EXPECT_EQ(summary["probes"]["tip_x"]["peak"], nlohmann::json({{"value", -0.4}, {"time", 1}}));
  EXPECT_EQ(summary["probes"]["tip_x"]["max"], nlohmann::json({{"value", 0.1}, {"time", 0.5}}));
  EXPECT_TRUE(summary["probes"]["tip_x"]["last"].is_null());
  EXPECT_EQ(summary["interface_work"], nlohmann::json({{"points", 12}, {"solid", 3}}));
}

TEST(Summary, OfARunThatNeverGotToAWindowIsStillJson) {
  RecordedRun run;
  write_summary(run.folder.path(), *run.recorder,
                {.status = "failed", .reason = "bytes that are no text: \xff"});
  const auto summary = nlohmann::json::parse(text_of(run.folder.path() / "summary.json"));
  EXPECT_EQ(summary["windows"], 0);
  EXPECT_TRUE(summary["probes"]["P01"]["peak"]["value"].is_null());
  EXPECT_TRUE(summary["exchange_seconds"].is_null());
}

TEST(ReplaceFile, SaysWhyItCannotWrite) {
  try {
    replace_file("/nowhere/summary.json", {"text"});
    FAIL() << "a file was written nowhere";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

TEST(Xdmf, HasNamesThatXmlReservesCharactersOf) {
  const std::string text = xdmf("results.h5", {0},
                                {{.name = "fluid",
                                  .arrays = {{"position", "/frames/fluid/position", 4, 2},
                                             {"a<b & \"c\"", "/frames/fluid/a<b & \"c\"", 4, 1}},
                                  .mesh = "/mesh/fluid",
                                  .cells = 4}});
  EXPECT_THAT(text, HasSubstr("Attribute Name=\"a&lt;b &amp; &quot;c&quot;\""));
  EXPECT_THAT(text, HasSubstr("results.h5:/frames/fluid/a&lt;b &amp; &quot;c&quot;"));
}

}  // namespace
}  // namespace cosurge
