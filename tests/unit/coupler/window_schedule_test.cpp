// Where windows end: on frames and on the end of the case, whatever binary numbers make of their times.
#include "coupler/window_schedule.hpp"

#include <gtest/gtest.h>

#include "common/case/case_file.hpp"

namespace cosurge {
namespace {

/// Goes through all windows of the longest size, and returns the smallest.
double smallest_window(WindowSchedule& schedule, double end, double interval) {
  double smallest = end;
  for (int k = 0; k < 100000 && !schedule.finished(); ++k) {
    const Window window = schedule.next(interval / 7);
    smallest = std::min(smallest, window.size);
    schedule.complete(window);
  }
  EXPECT_TRUE(schedule.finished());
  EXPECT_EQ(schedule.time(), end);
  return smallest;
}

TEST(WindowSchedule, HasNoWindowForTheRoundingOfTheLastFrame) {
  for (const auto& [end, interval] :
       {std::pair{0.45, 0.09}, {0.3, 0.1}, {0.7, 0.1}, {1.0, 0.3}, {33.0, 0.11}}) {
    const v1::Case the_case =
        load_case(COSURGE_SOURCE_DIR "/tests/cases/small_dam_break",
                  {fmt::format("time.end={}", end), fmt::format("output.frame_interval={}", interval),
                   "time.window=none"});
    WindowSchedule schedule(the_case);
    EXPECT_GT(smallest_window(schedule, end, interval), 1e-3 * interval)
        << end << " s, a frame every " << interval << " s";
  }
}

}  // namespace
}  // namespace cosurge
