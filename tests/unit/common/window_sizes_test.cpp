#include "common/case/window_sizes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "common/case/case_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

/// Windows to be expected in 0.1 s of a tank with an obstacle that has this motion.
double expected_windows(const std::string& motion) {
  const testing::ScratchFolder folder;
  std::ofstream(folder.path() / "m.csv") << "0, 0, 0, 0\n0.04, 0.2, 0, 0\n";
  std::ofstream(folder.path() / "case.toml") << fmt::format(R"(title = "moving wall"
gravity = [0, -9.81]
time = {{ end = 0.1 }}
[fluid]
spacing = 0.02
tank = {{ min = [0, 0], max = [0.8, 0.3] }}
water = [{{ min = [0.2, 0], max = [0.8, 0.1] }}]
obstacle = [{{ shape = {{ min = [0.1, 0.0], max = [0.2, 0.3] }} {} }}]
)",
                                                            motion);
  return 0.1 / expected_window(load_case(folder.path().string()));
}

// An obstacle at 5 m/s for 0.04 s, then at rest.
TEST(WindowSizes, MovingObstaclesSetTheWindowWhileTheyMove) {
  const double at_rest = expected_windows("");
  const double moving = 0.04 * 5 / (courant_number({}, true) * 0.02);
  EXPECT_GT(moving, 2 * at_rest);
  EXPECT_NEAR(expected_windows(", motion = { table = \"m.csv\" }"), moving + 0.6 * at_rest, 0.01 * moving);
}

}  // namespace
}  // namespace cosurge
