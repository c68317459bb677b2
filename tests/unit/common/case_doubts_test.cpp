#include "common/case/case_doubts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "common/case/case_file.hpp"
#include "tests/support/case_text.hpp"

namespace cosurge {
namespace {

using ::testing::HasSubstr;

struct Scene {
  std::string name;
  std::string motion;  // motion of an obstacle from x = 0.1 to 0.2 m in a tank of 0.8 x 0.3 m, for 1 s
  std::string doubt;   // "": none
};

const Scene scenes[] = {
    {"AStroke", "table = [[0, 0, 0, 0], [1, 0.05, 0, 0]]", ""},
    {"ASine", "amplitude = [0.02, 0], frequency = 1", ""},
    {"ATableThatGoesOnAfterTheEnd", "table = [[0.5, 0, 0, 0], [9, 0.05, 0, 0]]", ""},
    {"ATableThatEndsBeforeTheStart", "table = [[-5, 0, 0, 0], [-1, 0.05, 0, 0]]",
     "fluid.obstacle.0.motion: the table ends at -1 s, before the run starts at 0 s: nothing moves"},
    {"ATableThatStartsAfterTheEnd", "table = [[3, 0, 0, 0], [4, 0.05, 0, 0]]",
     "the table starts at 3 s, after the run ends at 1 s: nothing moves"},
    {"MillisecondsAsSeconds", "amplitude = [0.02, 0], frequency = 1000",
     "fluid.obstacle.0.motion: moves at 126 m/s"},
    {"AStepOfATable", "table = [[0, 0, 0, 0], [0.3, 0, 0, 0], [0.3001, 0.05, 0, 0]]",
     "times the speed of a fall"},
    {"IntoTheSide", "table = [[0, 0, 0, 0], [1, 0.9, 0, 0]]",
     "moves the obstacle into the side of the tank at t = 0."},
    {"IntoTheFloor", "table = [[0, 0, 0, 0], [1, 0, -0.1, 0]]",
     "moves the obstacle into the floor of the tank"},
    {"ByTurning", "angle = 1.0, pivot = [0.1, 0], frequency = 0.5", "moves the obstacle into the"},
    {"OutAtTheTop", "table = [[0, 0, 0, 0], [1, 0, 0.4, 0]]", ""},
};

class CaseDoubts : public ::testing::TestWithParam<Scene> {};

TEST_P(CaseDoubts, AreOfWhatIsHardlyMeant) {
  const testing::ScratchFolder folder;
  std::string motion = GetParam().motion;
  if (motion.starts_with("table")) {
    std::ofstream table(folder.path() / "m.csv");
    std::istringstream rows(motion.substr(motion.find("[[") + 1));
    for (std::string row; std::getline(rows, row, ']');)
      if (row.find('[') != std::string::npos) table << row.substr(row.find('[') + 1) << '\n';
    motion = "table = \"m.csv\"";
  }
  std::ofstream(folder.path() / "case.toml") << fmt::format(R"(title = "moving wall"
gravity = [0, -9.81]
time = {{ end = 1.0, window = 1e-3 }}
[fluid]
spacing = 0.02
tank = {{ min = [0, 0], max = [0.8, 0.3] }}
water = [{{ min = [0.2, 0], max = [0.8, 0.1] }}]
obstacle = [{{ shape = {{ min = [0.1, 0.0], max = [0.2, 0.3] }}, motion = {{ {} }} }}]
)",
                                                            motion);
  const std::vector<std::string> found = doubts(load_case(folder.path().string()));
  if (GetParam().doubt.empty())
    EXPECT_THAT(found, ::testing::IsEmpty());
  else
    EXPECT_THAT(found, ::testing::Contains(HasSubstr(GetParam().doubt)));
}

struct Number {
  std::string name;
  std::string setting;
  std::string doubt;  // "": none
};

const Number numbers[] = {
    {"AsItIs", "title=x", ""},
    {"GravityUpwards", "gravity=[0.0, 9.81]",
     "gravity: 9.81 m/s2 along y points out of the open top of the tank"},
    {"GravityInMillimetres", "gravity=[0.0, -9810.0]",
     "gravity: 9810 m/s2 is outside the usual range 1 to 30 m/s2"},
    {"NoGravity", "gravity=[0.0, 0.0]", ""},
    {"WaterInGramsACubicCentimetre", "fluid.density=1.0",
     "fluid.density: 1 kg/m3 is outside the usual range"},
    {"SolidInGramsACubicCentimetre", "solid.density=2.5",
     "solid.density: 2.5 kg/m3 is outside the usual range"},
    {"Foam", "solid.density=30", ""},
    {"ModulusInGigapascals", "solid.young_modulus=210",
     "solid.young_modulus: 210 Pa is outside the usual range"},
    {"Steel", "solid.young_modulus=2.1e11", ""},
};

class NumberDoubts : public ::testing::TestWithParam<Number> {};

TEST_P(NumberDoubts, AreOfOtherUnits) {
  const std::vector<std::string> found = doubts(load_case(testing::CaseText().file(), {GetParam().setting}));
  if (GetParam().doubt.empty())
    EXPECT_THAT(found, ::testing::IsEmpty());
  else
    EXPECT_THAT(found, ::testing::ElementsAre(HasSubstr(GetParam().doubt)));
}

INSTANTIATE_TEST_SUITE_P(Units, NumberDoubts, ::testing::ValuesIn(numbers),
                         [](const auto& number) { return number.param.name; });

INSTANTIATE_TEST_SUITE_P(Motions, CaseDoubts, ::testing::ValuesIn(scenes),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace cosurge
