// The program in the ways in which people use it: from any folder, several at a time, in pipes, in queues.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "common/case/probe_columns.hpp"
#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/results.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double patience = 900;  // s: with sanitizers, on a busy machine; ten is enough on an idle one

/// A tank of 0.4 x 0.4 m with 200 particles of water, for a moment.
constexpr const char* small_tank = R"(title = "small"
gravity = [0.0, -9.81]
[time]
end = 0.02
window = 1.0e-3
[output]
frame_interval = 0.01
[fluid]
spacing = 0.01
tank = { min = [0.0, 0.0], max = [0.4, 0.4] }
water = [{ min = [0.0, 0.0], max = [0.1, 0.2] }]
)";

constexpr const char* forever = "--set time.end=1000 output.frame_interval=0.05";

class WaysOfUse : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(scratch_.path() / "scene");
    write_case(small_tank);
  }

  void write_case(const std::string& text) { std::ofstream(scene() / "case.toml") << text; }

  fs::path scene() const { return scratch_.path() / "scene"; }

  /// Starts a command line in a folder, with its own folder for temporary files.
  Program start(const std::string& line, const fs::path& where, const std::string& name = "out") {
    fs::create_directories(temporary());
    return Program({"/bin/bash", "-c",
                    fmt::format("cd {}; export TMPDIR={}; {}", where.string(), temporary().string(), line)},
                   scratch_.path() / (name + ".log"));
  }

  /// Runs it to its end; the output.
  std::string run(const std::string& line, const fs::path& where, int status = 0) {
    Program program = start(line, where);
    EXPECT_EQ(program.wait(patience), status) << program.output();
    return program.output();
  }

  std::string cosurge(const std::string& arguments) const { return cosurge_program + " " + arguments; }
  fs::path temporary() const { return scratch_.path() / "t"; }

  ScratchFolder scratch_;
};

TEST_F(WaysOfUse, ARunInTheFolderOfItsCaseIsNamedAfterIt) {
  for (int k = 0; k < 2; ++k) run(cosurge("run . --in-process"), scene());
  EXPECT_TRUE(fs::exists(scene() / "results/scene/results.h5"));
  EXPECT_TRUE(fs::exists(scene() / "results/scene-2/results.h5"));
  fs::create_directories(scene() / "sub");
  run(cosurge("run .. --in-process"), scene() / "sub");
  run(cosurge("run ../ --in-process"), scene() / "sub");
  run(cosurge("run ../case.toml --in-process"), scene() / "sub");
  for (const char* name : {"scene", "scene-2", "scene-3"})
    EXPECT_TRUE(fs::exists(scene() / "sub/results" / name / "results.h5")) << name;
  EXPECT_FALSE(fs::exists(scene() / "sub/results.h5"));
}

TEST_F(WaysOfUse, RunsThatStartTogetherTakeDifferentFolders) {
  std::string all;
  for (int k = 0; k < 6; ++k) all += cosurge("run scene --in-process --threads 1 & ");
  run(all + "wait", scratch_.path());
  int results = 0;
  for (const auto& entry : fs::directory_iterator(scratch_.path() / "results"))
    results += fs::exists(entry.path() / "summary.json") ? 1 : 0;
  EXPECT_EQ(results, 6);
  // Two runs with the same folder name: one of them gets it.
  const std::string one = cosurge("run scene --in-process --threads 1 --out same");
  const std::string output = run(fmt::format("{0} & {0} & {0} & wait", one), scratch_.path());
  std::size_t refused = 0;
  for (auto at = output.find("choose another --out"); at != std::string::npos;
       at = output.find("choose another --out", at + 1))
    ++refused;
  EXPECT_EQ(refused, 2) << output;
  EXPECT_EQ(read_summary(scratch_.path() / "same").at("status"), "finished");
}

TEST_F(WaysOfUse, SignalsThatAreMeantToEndARunLeaveASummaryAndNothingTemporary) {
  for (const int signal : {SIGHUP, SIGUSR1, SIGUSR2, SIGTERM, SIGXCPU}) {
    const std::string name = fmt::format("signal{}", signal);
    Program program =
        start("exec " + cosurge(fmt::format("run scene --out {} {}", name, forever)), scratch_.path());
    ASSERT_TRUE(program.says("results:", patience)) << program.output();
    kill(program.pid(), signal);
    EXPECT_EQ(program.wait(patience), 130) << program.output();
    EXPECT_EQ(read_summary(scratch_.path() / name).at("status"), "interrupted");
    EXPECT_THAT(read_summary(scratch_.path() / name).at("reason"),
                HasSubstr(fmt::format("by signal {}", signal)));
    EXPECT_TRUE(fs::is_empty(temporary())) << signal;
  }
}

TEST_F(WaysOfUse, AHangUpOfTheWholeGroupIsInOrder) {
  // As when a terminal closes: every process of the group gets it.
  Program program =
      start("exec setsid " + cosurge(fmt::format("run scene --out hung {}", forever)), scratch_.path());
  ASSERT_TRUE(program.says("results:", patience)) << program.output();
  kill(-program.pid(), SIGHUP);
  EXPECT_EQ(program.wait(patience), 130) << program.output();
  EXPECT_EQ(read_summary(scratch_.path() / "hung").at("status"), "interrupted");
  EXPECT_TRUE(fs::is_empty(temporary()));
}

TEST_F(WaysOfUse, NohupOutlivesAHangUp) {
  Program program =
      start("exec nohup " + cosurge("run scene --out kept --set time.end=0.3"), scratch_.path());
  ASSERT_TRUE(program.says("results:", patience)) << program.output();
  kill(program.pid(), SIGHUP);
  EXPECT_EQ(program.wait(patience), 0) << program.output();
  EXPECT_EQ(read_summary(scratch_.path() / "kept").at("status"), "finished");
}

TEST_F(WaysOfUse, AReaderThatGoesAwayEndsTheRunInOrder) {
  Program program =
      start("set -o pipefail; " + cosurge(fmt::format("run scene --out piped {}", forever)) + " | head -n 1",
            scratch_.path());
  EXPECT_EQ(program.wait(patience), 130) << program.output();
  EXPECT_EQ(read_summary(scratch_.path() / "piped").at("status"), "interrupted");
  EXPECT_TRUE(fs::is_empty(temporary()));
}

TEST_F(WaysOfUse, HistoriesAreWrittenAsATableWithUnits) {
  run(cosurge("run scene --in-process --out r"), scratch_.path());
  const std::string all = run(cosurge("csv r"), scratch_.path());
  EXPECT_THAT(all, StartsWith("time [s],window [s],"));
  EXPECT_THAT(all, HasSubstr("fluid/front [m]"));
  run(cosurge("csv r/results.h5 --columns fluid/front fluid/lost --out t.csv"), scratch_.path());
  std::ifstream file(scratch_.path() / "t.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  EXPECT_EQ(lines.front(), "time [s],window [s],fluid/front [m],fluid/lost");
  const Datasets results = read_results(scratch_.path() / "r");
  ASSERT_EQ(lines.size(), 1 + results.at("/history/time").size());
  std::istringstream last(lines.back());
  std::vector<double> values;
  for (std::string cell; std::getline(last, cell, ',');) values.push_back(std::stod(cell));
  EXPECT_EQ(values,
            std::vector<double>({results.at("/history/time").back(), results.at("/history/window").back(),
                                 results.at("/history/fluid/front").back(), 0}));
  EXPECT_THAT(run(cosurge("csv r --out t.csv"), scratch_.path(), 1), HasSubstr("t.csv: exists already"));
  EXPECT_THAT(run(cosurge("csv r --columns fluid/frnt"), scratch_.path(), 1),
              HasSubstr("no column fluid/frnt; there"));
  EXPECT_THAT(run(cosurge("csv nothing"), scratch_.path(), 1), HasSubstr("nothing: contains no results"));
}

TEST_F(WaysOfUse, AMisspeltCommandIsAnsweredWithTheNearest) {
  EXPECT_THAT(run(cosurge("chekc scene"), scratch_.path(), 2), HasSubstr("did you mean cosurge check?"));
  EXPECT_THAT(run(cosurge("rnu scene"), scratch_.path(), 2), HasSubstr("did you mean cosurge run?"));
  EXPECT_THAT(run(cosurge("scene"), scratch_.path(), 2), Not(HasSubstr("did you mean")));
}

TEST_F(WaysOfUse, AdviseShowsNumbersVerdictsAndOneRecommendation) {
  const std::string piston = COSURGE_SOURCE_DIR "/cases/sprung_piston";
  const std::string advice = run(cosurge("advise " + piston), scratch_.path());
  for (const char* line :
       {"mu about 0.5", "dry 2.449 Hz", "wet about 2 Hz, a period of 1000 windows",
        "Use the model sprung and the scheme weak", "about 4000 of at most 0.0005 s", "fluid.courant is 0.5"})
    EXPECT_THAT(advice, HasSubstr(line));
  EXPECT_THAT(advice, Not(HasSubstr("prescribed motions")));
  const std::string baffle = COSURGE_SOURCE_DIR "/cases/sloshing_baffle";
  EXPECT_THAT(run(cosurge("advise " + baffle), scratch_.path()), HasSubstr("prescribed motions"));
  const std::string wave = COSURGE_SOURCE_DIR "/cases/standing_wave";
  EXPECT_THAT(run(cosurge("advise " + wave), scratch_.path(), 1), HasSubstr("has no [solid]"));
}

TEST_F(WaysOfUse, LostWaterIsToldAtTheEndAndEndsTheRunWhereItIsTooMuch) {
  write_case(R"(title = "shaken tank"
gravity = [0.0, -9.81]
[time]
end = 1.0
window = 2.0e-3
[fluid]
spacing = 0.02
tank = { min = [0.0, 0.0], max = [0.4, 0.5] }
water = [{ min = [0.0, 0.0], max = [0.4, 0.4] }]
[fluid.tank_motion]
amplitude = [0.15, 0.0]
frequency = 1.2
ramp = 0.2
[output]
frame_interval = 0.1
)");
  const std::string failed = run(cosurge("run scene --in-process --out a"), scratch_.path(), 1);
  EXPECT_THAT(failed, HasSubstr("water particles"));
  EXPECT_THAT(failed, HasSubstr("fluid.most_lost = 0.01 allows 1 %"));
  EXPECT_EQ(read_summary(scratch_.path() / "a").at("status"), "failed");
  const std::string told =
      run(cosurge("run scene --in-process --out b --set fluid.most_lost=1"), scratch_.path());
  EXPECT_THAT(told, HasSubstr("finished"));
  EXPECT_THAT(told, HasSubstr("water lost: "));
  EXPECT_THAT(told, HasSubstr(" of 400 particles ("));
  const Datasets results = read_results(scratch_.path() / "b");
  double sides = 0;
  for (const char* side : {"x_min", "x_max", "y_min", "y_max"})
    sides += results.at(fmt::format("/history/fluid/lost_{}", side)).back();
  EXPECT_GT(sides, 4);
  EXPECT_EQ(sides, results.at("/history/fluid/lost").back());
  EXPECT_EQ(results.at("/history/fluid/water").back(), 400 - sides);
}

TEST_F(WaysOfUse, AMapTakesVectorsAndFailsWhereEveryCellHas) {
  const std::string map =
      cosurge("map " + small_dam_break + " --set time.end=0.005 solid.model=modal --out m.csv --over ");
  EXPECT_THAT(run(map + "'gravity=[0,-9.81],[0.0,-1.62]'", scratch_.path()),
              HasSubstr("[0.0,-1.62]: stable"));
  std::ifstream file(scratch_.path() / "m.csv");
  std::stringstream table;
  table << file.rdbuf();
  EXPECT_THAT(table.str(), HasSubstr("\n\"[0,-9.81]\",stable,"));
  fs::remove(scratch_.path() / "m.csv");
  EXPECT_THAT(run(map + "solid.density=-1,-2", scratch_.path(), 1), HasSubstr("every cell failed"));
}

// The names that common/case/probe_columns.cpp keeps from probes are those of the solvers.
TEST_F(WaysOfUse, TheColumnsOfTheResultsAreThoseThatNoProbeMayHave) {
  for (const char* model : {"fem", "rigid", "sprung", "mps", "modal", "hamiltonian"}) {
    const std::string spring =
        std::string(model) == "sprung" ? " 'solid.sprung.spring=[{ motion = \"x\" }]'" : "";
    run(cosurge(fmt::format("run {} --in-process --out {} --set time.end=0.002 output.frame_interval=0.001 "
                            "output.probe=[] solid.model={}{}",
                            small_dam_break, model, model, spring)),
        scratch_.path());
    for (const auto& [name, values] : read_results(scratch_.path() / model)) {
      for (const std::string group : {"fluid", "solid"}) {
        const std::string begin = "/history/" + group + "/";
        if (!name.starts_with(begin)) continue;
        const bool directed = name.size() > 2 && name[name.size() - 2] == '_' && name.back() >= 'x';
        if (group == "solid" && !directed) continue;  // probes of displacement have directions
        EXPECT_TRUE(is_own_column(group, name.substr(begin.size()))) << model << " " << name;
      }
    }
  }
}

/// Before, it fell 34 mm through the floor, until the pressure diverged.
TEST_F(WaysOfUse, ASteelBlockThatSinksStandsOnTheFloorAndTheRunSaysSo) {
  std::ofstream(scene() / "block.csv") << "0.25,0.12\n0.35,0.12\n0.35,0.2\n0.25,0.2\n";
  write_case(R"(title = "block"
gravity = [0.0, -9.81]
[time]
end = 1.7
window = 1.0e-3
[fluid]
spacing = 0.01
tank = { min = [0.0, 0.0], max = [0.6, 0.4] }
water = [{ min = [0.0, 0.0], max = [0.6, 0.1] }]
[solid]
model = "sprung"
density = 7800
[[solid.body]]
shape = { outline = "block.csv" }
[[solid.sprung.spring]]
motion = "x"
[[solid.sprung.spring]]
motion = "y"
[[solid.sprung.spring]]
motion = "turn"
[coupling]
scheme = "auto"
[output]
frame_interval = 0.1
probe = [{ name = "b", quantity = "displacement", position = [0.3, 0.16] }]
)");
  const std::string output = run(cosurge("run . --out out"), scene());
  EXPECT_THAT(output, HasSubstr("s: solid.body.0 touches the floor of the tank, near (0."));
  const Datasets results = read_results(scene() / "out");
  const auto height = results.at("/history/solid/b_y"), time = results.at("/history/time");
  const auto push = results.at("/history/solid/contact_load_y"), size = results.at("/history/window");
  double impulse = 0, from = 0;
  for (std::size_t k = 0; k < height.size(); ++k) {
    EXPECT_GT(height[k], -0.121);  // v / omega of its own fall: 0.5 mm at 1 m/s
    // it bounces on the water that it squeezes out, and is at rest a second later
    if (time[k] < 1.4) from = time[k];
    if (time[k] >= 1.4) impulse += push[k] * size[k];
  }
  EXPECT_LT(height.back(), -0.115);
  // The floor carries the weight, except for the force of the water: at most the buoyancy, and the pressure
  // of water that is squeezed out.
  EXPECT_GT(impulse / (time.back() - from), 0.5 * 7800 * 0.1 * 0.08 * 9.81);
  EXPECT_LT(impulse / (time.back() - from), 1.1 * 7800 * 0.1 * 0.08 * 9.81);
}

}  // namespace
}  // namespace cosurge::testing
