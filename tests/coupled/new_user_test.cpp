// Messages for a new user's cases before and during a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "common/vec.hpp"
#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double patience = 900;  // s: with sanitizers, on a busy machine

class NewUser : public ::testing::Test {
 protected:
  std::string cosurge(const std::vector<std::string>& arguments, const std::string& text) {
    std::ofstream(scratch_.path() / "case.toml") << text;
    std::vector<std::string> command = {cosurge_program};
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.push_back(scratch_.path().string());
    Program program(command, scratch_.path() / "out.log");
    EXPECT_EQ(program.wait(patience), 0);
    return program.output();
  }
  ScratchFolder scratch_;
};

TEST_F(NewUser, IsWarnedOfUnitsAndToldOfFreeBodiesBeforeTheRun) {
  const std::string text = R"(title = "units"
gravity = [0.0, 9.81]
time = { end = 0.01, window = 1e-3 }
output = { frame_interval = 0.01 }
[fluid]
spacing = 0.01
density = 1.0
tank = { min = [0, 0], max = [0.4, 0.3] }
water = [{ min = [0, 0], max = [0.1, 0.1] }]
[solid]
model = "fem"
density = 500
young_modulus = 1e6
[[solid.body]]
box = { min = [0.2, 0.1], max = [0.24, 0.2] }
)";
  const std::string checked = cosurge({"check"}, text);
  EXPECT_THAT(checked,
              HasSubstr("warning: gravity: 9.81 m/s2 along y points out of the open top of the tank"));
  EXPECT_THAT(checked, HasSubstr("warning: fluid.density: 1 kg/m3 is outside the usual range"));
  EXPECT_THAT(checked, HasSubstr("free         solid.body.0: no clamp or support holds it"));
  EXPECT_THAT(cosurge({"run", "--out", (scratch_.path() / "out").string()}, text),
              HasSubstr("warning: fluid.density: 1 kg/m3"));
}

/// Before, such a body could only translate.
TEST_F(NewUser, HasABoxThatFloatsInSpaceAndTurns) {
  const std::string output = cosurge({"run", "--out", (scratch_.path() / "out").string()}, R"(title = "box"
dimension = 3
gravity = [0.0, 0.0, -9.81]
time = { end = 0.3, window = 2e-3 }
[fluid]
spacing = 0.01
tank = { min = [0.0, 0.0, 0.0], max = [0.3, 0.3, 0.24] }
water = [{ min = [0.0, 0.0, 0.0], max = [0.3, 0.3, 0.08] }]
[solid]
model = "sprung"
density = 300.0
[[solid.body]]
box = { min = [0.06, 0.1, 0.08], max = [0.24, 0.2, 0.16] }
[[solid.sprung.spring]]
motion = "z"
[[solid.sprung.spring]]
motion = "turn_x"
preload = 0.05  # N m
[[solid.sprung.spring]]
motion = "turn_y"
[[solid.sprung.spring]]
motion = "turn_z"
[coupling]
scheme = "strong"
[output]
frame_interval = 0.1
[[output.probe]]
name = "left"
quantity = "displacement"
position = [0.16, 0.1, 0.12]
[[output.probe]]
name = "right"
quantity = "displacement"
position = [0.16, 0.2, 0.12]
)");
  EXPECT_THAT(output, Not(HasSubstr("unreliable result")));
  // Both move up and down more than to the side: the progress line has the way, not its x.
  const auto at = output.rfind("  left ");
  ASSERT_NE(at, std::string::npos);
  const double shown = 1e-3 * std::stod(output.substr(at + 7));
  const Datasets results = read_results(scratch_.path() / "out");
  const auto left = results.at("/history/solid/left_z"), right = results.at("/history/solid/right_z");
  const auto aside = results.at("/history/solid/left_y"), along = results.at("/history/solid/left_x");
  EXPECT_NEAR(shown, Vec<3>(along.back(), aside.back(), left.back()).norm(), 1e-5);
  EXPECT_GT(shown, 1e-3);
  // From y to z; its moment alone would rotate it by 0.05 t^2 / 2 I = 0.9 rad.
  EXPECT_GT((right.back() - left.back()) / 0.1, 0.05);
  EXPECT_LT((right.back() - left.back()) / 0.1, 0.9);
  const auto given = results.at("/history/coupling/work_points"),
             taken = results.at("/history/solid/interface_work");
  EXPECT_NEAR(given.back(), taken.back(), 1e-9 * std::abs(taken.back()));
}

}  // namespace
}  // namespace cosurge::testing
