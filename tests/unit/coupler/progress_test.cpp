// The progress line at any width, and what is measured for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/case/case_file.hpp"
#include "coupler/progress/progress_meter.hpp"

namespace cosurge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ProgressState sample() {
  ProgressState state;
  state.time = 0.1234;
  state.end = 1;
  state.window = 1234;
  state.window_size = 2e-4;
  state.seconds_per_window = 0.0123;
  state.seconds_left = 83;
  state.probe = "tip 12.34 mm";
  state.max_speed = 2.31;
  state.iterations = 4;
  state.unconverged = 2;
  state.added_mass_ratio = 1.62;
  return state;
}

TEST(ProgressLine, FitsEveryWidth) {
  std::size_t before = 0;
  for (std::size_t width = 1; width <= 250; ++width) {
    const std::string line = progress_line(sample(), width);
    EXPECT_LE(line.size(), width);
    EXPECT_GE(line.size(), before) << "a wider line says no less, at " << width;
    before = line.size();
  }
}

TEST(ProgressLine, KeepsWhatMattersMost) {
  EXPECT_EQ(progress_line(sample(), 30), "t 0.1234/1 s  1:23 left");
  EXPECT_EQ(progress_line(sample(), 59), "t 0.1234/1 s  tip 12.34 mm  2 not converged  1:23 left");
  EXPECT_EQ(
      progress_line(sample(), 250),
      "t 0.1234/1 s  tip 12.34 mm  2 not converged  mu 1.62  iterations 4  speed 2.31 m/s  window 1234  "
      "dt 2.00e-04 s  12.3 ms/window  1:23 left");
}

TEST(ProgressLine, LeavesOutWhatMeansNothing) {
  ProgressState state = sample();
  state.probe = "";
  state.max_speed = std::numeric_limits<double>::quiet_NaN();
  state.iterations = 1;
  state.unconverged = 0;
  state.added_mass_ratio = 0.02;
  EXPECT_EQ(progress_line(state, 250), "t 0.1234/1 s  window 1234  dt 2.00e-04 s  12.3 ms/window  1:23 left");
}

TEST(ProgressLine, WritesValuesInReadableUnits) {
  EXPECT_EQ(with_unit(0.04712, "m"), "47.12 mm");
  EXPECT_EQ(with_unit(12.5, "m"), "12.5 m");
  EXPECT_EQ(with_unit(-831.24, "Pa"), "-831.2 Pa");
  EXPECT_EQ(with_unit(123456, "Pa"), "123.5 kPa");
  EXPECT_EQ(with_unit(std::nan(""), "Pa"), "- Pa");
  EXPECT_EQ(clock_text(3723), "1:02:03");
}

class Meter : public ::testing::Test {
 protected:
  const v1::Case case_ = load_case(COSURGE_SOURCE_DIR "/tests/cases/small_dam_break", {"time.end=1"});
  const std::vector<Member> members_ = {
      {.name = "fluid", .identity = {}, .setup = {.columns = {{"max_speed", "m/s"}, {"foot", "Pa"}}}},
      {.name = "solid", .identity = {}, .setup = {.columns = {{"tip_x", "m"}, {"tip_y", "m"}}}}};
  const std::vector<Column> columns_ = {{"iterations", "-"}, {"added_mass_ratio", "-"}};
  const Reports reports_ = {{.values = {3, 700}}, {.values = {0.003, 0.004}}};
};

TEST_F(Meter, ShowsTheLengthOfTheFirstProbe) {
  ProgressMeter meter(case_, members_, columns_);
  EXPECT_FALSE(meter.count({.index = 0, .start = 0, .size = 0.1}, 1000));
  const ProgressState state = meter.state(reports_, {5, 1.5});
  EXPECT_EQ(state.probe, "tip 5.00 mm");
  EXPECT_EQ(state.max_speed, 3);
  EXPECT_EQ(state.iterations, 5);
  EXPECT_EQ(state.added_mass_ratio, 1.5);
}

TEST_F(Meter, CountsTheTimeLeftOfAResumedRunFromItsResumption) {
  ProgressMeter meter(case_, members_, columns_);
  meter.count({.index = 900, .start = 0.9, .size = 0.05}, 1000);
  const ProgressState state = meter.state(reports_, {1, 0});
  EXPECT_NEAR(state.seconds_left, state.seconds, 1e-9) << "half of what is left has been computed";
}

TEST_F(Meter, IsDueAtTheEnd) {
  ProgressMeter meter(case_, members_, columns_);
  EXPECT_TRUE(meter.count({.index = 9, .start = 0.9, .size = 0.1}, 1000));
  EXPECT_EQ(meter.state(reports_, {1, 0}).seconds_left, 0);
}

TEST_F(Meter, GivesAllColumnsOfAllProbes) {
  ProgressMeter meter(case_, members_, columns_);
  std::vector<std::string> names;
  for (const ProbeValue& probe : meter.probes(reports_)) names.push_back(probe.name);
  EXPECT_THAT(names, ::testing::ElementsAre("solid/tip_x", "solid/tip_y", "fluid/foot"));
}

}  // namespace
}  // namespace cosurge
