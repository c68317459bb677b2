// libcosurge as users call it: a case, their own participants, observers.
#include "coupler/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/faults.hpp"
#include "common/solvers.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::string small_dam_break = COSURGE_SOURCE_DIR "/tests/cases/small_dam_break";
const std::vector<std::string> short_run = {"time.end=0.03", "coupling.scheme=weak"};

/// All values of the windows except wall times, and the number of frames.
class Numbers : public Observer {
 public:
  explicit Numbers(Simulation& simulation) {
    simulation.begin();
    for (const Member& member : simulation.members()) columns.push_back(member.setup.columns);
    simulation.observe(*this);
  }

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override {
    values.push_back({window.start, window.size});
    for (std::size_t m = 0; m < reports.size(); ++m)
      for (std::size_t c = 0; c < columns[m].size(); ++c)
        if (columns[m][c].unit != "s") values.back().push_back(reports[m].values[c]);
    last = reports;
    values.back().insert(values.back().end(), coupling.begin(), coupling.end());
  }
  void frame(double, const std::vector<Snapshot>&) override { ++frames; }

  std::vector<std::vector<Column>> columns;
  std::vector<std::vector<double>> values;
  Reports last;
  int frames = 0;
};

/// A structure that moves at a constant speed.
std::unique_ptr<MockSolid> moving_plate(double speed) {
  auto solid = std::make_unique<MockSolid>();
  solid->state = {0};
  solid->on_initialize = [](const v1::Case& the_case, const Interface& interface, const InterfaceLoad&,
                            InterfaceMotion& motion) {
    motion = InterfaceMotion::at_rest(the_case.dimension(), interface.points());
    return Setup{.columns = {{"way", "m"}}, .particles = 1, .window = 1, .substep = 0};
  };
  solid->on_advance = [speed, &way = solid->state[0]](const Window& window, const InterfaceLoad&,
                                                      InterfaceMotion& motion) {
    way += speed * window.size;
    motion.displacement.row(0).setConstant(way);
    motion.velocity.row(0).setConstant(speed);
    return Report{.values = {way}, .window = 1};
  };
  return solid;
}

TEST(Simulation, GivesTheSameBitsWithSolversHereInThreadsAndInProcesses) {
  const ScratchFolder scratch;
  std::vector<Numbers> runs;
  for (const int way : {0, 1, 2}) {
    Simulation simulation = Simulation::of_file(small_dam_break, short_run);
    const Reach fluid{.threads = way + 1, .log = scratch.path() / "fluid.log"};
    if (way == 1) simulation.in_thread(make_fluid_solver(), fluid);
    if (way == 1) simulation.in_thread(make_solid_solver());
    if (way == 2) simulation.in_process(Role::fluid, "", fluid);
    if (way == 2) simulation.in_process(Role::solid, "", {.log = scratch.path() / "solid.log"});
    Numbers numbers(simulation);
    EXPECT_TRUE(simulation.run());
    runs.push_back(numbers);
    EXPECT_DOUBLE_EQ(simulation.time(), 0.03);
  }
  EXPECT_GE(runs[0].values.size(), 150U);  // windows of 2e-4 s at most
  EXPECT_EQ(runs[0].frames, 3);
  EXPECT_TRUE(runs[0].values == runs[1].values);
  EXPECT_TRUE(runs[0].values == runs[2].values);
}

TEST(Simulation, RunsASolidOfTheUsersOwnHereAndInAThreadAndShowsWhatItSays) {
  std::vector<Numbers> runs;
  for (const int way : {0, 1}) {
    Simulation simulation = Simulation::of_file(small_dam_break, short_run);
    way == 0 ? simulation.here(moving_plate(0.1)) : simulation.in_thread(moving_plate(0.1));
    Numbers numbers(simulation);
    simulation.run();
    ASSERT_EQ(simulation.members().size(), 2U);
    EXPECT_EQ(simulation.members()[1].identity.program, "mock_solid");
    EXPECT_NEAR(numbers.last[1].values[0], 0.1 * 0.03, 1e-15);
    runs.push_back(numbers);
  }
  EXPECT_TRUE(runs[0].values == runs[1].values);
}

TEST(Simulation, GoesOnFromAStateAndAfterAStopToTheSameBits) {
  Simulation first = Simulation::of_file(small_dam_break, short_run);
  first.here(moving_plate(0.1));
  Numbers whole(first);
  first.run();

  Simulation begun = Simulation::of_file(small_dam_break, short_run);
  begun.here(moving_plate(0.1));
  Numbers parts(begun);
  EXPECT_FALSE(begun.run([&] { return parts.values.size() >= 40; }));
  EXPECT_FALSE(begun.run([&] { return parts.values.size() >= 80; }));
  const std::string state = begun.save();

  Simulation resumed = Simulation::of_file(small_dam_break, short_run);
  resumed.here(moving_plate(0.1));
  resumed.observe(parts);
  resumed.restore(state);
  EXPECT_TRUE(resumed.run());
  EXPECT_TRUE(parts.values == whole.values);
}

TEST(Simulation, ReadsACaseFromATextAndSaysItsLines) {
  const std::string text =
      "title = \"tank\"\ngravity = [0.0, -9.81]\ntime = { end = 0.01, window = 1e-3 }\n[fluid]\nspacing = "
      "0.01\n"
      "tank = { min = [0.0, 0.0], max = [0.4, 0.4] }\nwater = [{ min = [0.0, 0.0], max = [0.1, 0.2] }]\n";
  Simulation simulation = Simulation::of_text(text, {"time.end=0.02"});
  EXPECT_TRUE(simulation.run());
  EXPECT_DOUBLE_EQ(simulation.time(), 0.02);
  EXPECT_EQ(simulation.solid(), nullptr);
  EXPECT_THAT([&] { Simulation::of_text(text + "depth = 1\n"); },
              ThrowsMessage<Error>(HasSubstr("case:8: fluid.depth: unknown key")));
}

TEST(Simulation, RefusesParticipantsThatHaveNoPlace) {
  Simulation simulation = Simulation::of_file(small_dam_break, short_run);
  simulation.here(moving_plate(0));
  EXPECT_THAT([&] { simulation.here(moving_plate(0)); },
              ThrowsMessage<Error>(HasSubstr("the solid has a solver already")));
  EXPECT_THAT([&] { simulation.members(); }, ThrowsMessage<Error>(HasSubstr("has not begun")));
  simulation.begin();
  EXPECT_THAT([&] { simulation.in_process(Role::fluid); }, ThrowsMessage<Error>(HasSubstr("has begun")));

  Simulation flat = Simulation::of_file(small_dam_break, short_run);
  const auto add_spatial = [&] {
    auto solid = moving_plate(0);
    solid->who.dimensions = {3};
    flat.here(std::move(solid));
  };
  EXPECT_THAT(add_spatial, ThrowsMessage<Error>(HasSubstr("mock_solid does not compute scenes of 2 dim")));
  EXPECT_THAT([&] { flat.in_thread(nullptr); }, ThrowsMessage<Error>(HasSubstr("the pointer is empty")));

  Simulation water = Simulation::of_file(COSURGE_SOURCE_DIR "/cases/standing_wave");
  EXPECT_THAT([&] { water.here(moving_plate(0)); }, ThrowsMessage<Error>(HasSubstr("has no [solid]")));
}

TEST(Simulation, GivesEachOfSeveralStructuresASolverByItsName) {
  const std::string hull = COSURGE_SOURCE_DIR "/cases/rigid_hull";
  const std::vector<std::string> words = {"time.end=0.02"};
  Simulation own = Simulation::of_file(hull, words);
  Numbers first(own);
  own.run();
  const ScratchFolder scratch;
  Simulation apart = Simulation::of_file(hull, words);
  apart.in_process(Role::solid, "", {.log = scratch.path() / "panel.log", .solid = "panel"});
  EXPECT_THAT([&] { apart.in_thread(make_solid_solver(), {.solid = "panel"}); },
              ThrowsMessage<Error>(HasSubstr("the panel has a solver already")));
  apart.here(make_solid_solver(), "hull");
  Numbers second(apart);
  apart.run();
  EXPECT_GE(first.values.size(), 20U);
  EXPECT_TRUE(first.values == second.values);

  Simulation named = Simulation::of_file(hull, words), one = Simulation::of_file(small_dam_break, short_run);
  EXPECT_THAT([&] { named.here(moving_plate(0)); },
              ThrowsMessage<Error>("the case has several [[solid]]: name one of hull, panel"));
  EXPECT_THAT([&] { named.here(moving_plate(0), "keel"); },
              ThrowsMessage<Error>("the case has several [[solid]]: name one of hull, panel, not \"keel\""));
  EXPECT_THAT([&] { named.in_process(Role::fluid, "", {.solid = "hull"}); },
              ThrowsMessage<Error>("\"hull\" is the name of a structure, not of the fluid"));
  EXPECT_THAT([&] { one.here(moving_plate(0), "hull"); },
              ThrowsMessage<Error>(HasSubstr("the case has one [solid]")));
}

TEST(Simulation, GivesUpTheWaitForASolverThatNobodyStarts) {
  Simulation simulation = Simulation::of_file(small_dam_break, short_run);
  EXPECT_THAT(simulation.by_hand(Role::solid), HasSubstr("solid_solver --connect "));
  int asked = 0;
  simulation.give_up_when([&] { return ++asked > 3; }, [] { return false; });
  EXPECT_THROW(simulation.run(), Interrupted);
}

}  // namespace
}  // namespace cosurge::testing
