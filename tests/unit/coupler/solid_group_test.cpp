#include "coupler/solid_group.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "common/case/several_solids.hpp"
#include "common/error.hpp"
#include "tests/support/mock_participant.hpp"

namespace cosurge {
namespace {

using ::testing::ElementsAre;
using testing::MockSolid;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

/// Two structures: the first has bodies 0 and 1, the second body 2.
v1::Case two_structures() {
  v1::Case the_case = testing::piston_case();
  for (const int bodies : {2, 1}) {
    v1::Solid& solid = *the_case.add_solids();
    solid.set_density(1000);
    solid.set_name(bodies == 2 ? "hull" : "panel");
    for (int b = 0; b < bodies; ++b)
      for (const double end : {0.0, 1.0}) {
        v1::Box& box = *(end == 0 ? solid.add_body() : solid.mutable_body(b))->mutable_box();
        for (int k = 0; k < 2; ++k) (end == 0 ? box.add_min(10 * b) : box.add_max(10 * b + 1));
      }
  }
  join_solids(the_case);
  return the_case;
}

/// Points whose bodies alternate, so that those of a structure do not follow each other.
Interface mixed_points() {
  Interface interface {
    .dimension = 2, .position = Field(2, 5), .area = Field::Ones(2, 5), .body = { 2, 0, 2, 1, 0 }
  };
  interface.position << 1, 2, 3, 4, 5, 0, 0, 0, 0, 0;
  return interface;
}

/// Moves each point by its own number times its load; its energy is `energy`.
std::unique_ptr<MockSolid> follower(double energy, double window, const std::string& column) {
  auto solid = std::make_unique<MockSolid>();
  solid->state = {0};
  solid->on_initialize = [=](const v1::Case& the_case, const Interface& interface, const InterfaceLoad&,
                             InterfaceMotion& motion) {
    motion = InterfaceMotion::at_rest(the_case.dimension(), interface.points());
    motion.displacement = interface.position;
    motion.frequency = energy;
    return Setup{.columns = {{"kinetic_energy", "J"}, {column, "-"}}, .particles = 7, .window = window};
  };
  solid->on_advance = [=, &seen = solid->state[0]](const Window&, const InterfaceLoad& load,
                                                   InterfaceMotion& motion) {
    motion.velocity = 2 * load.force;
    motion.ramp_increment = 3 * load.force;
    motion.modes = {{.shape = load.force, .mobility = energy, .load = load.pressure.sum()}};
    motion.frequency = energy;
    seen += 1;
    return Report{.values = {energy, seen}, .window = window, .notes = {"moved"}};
  };
  return solid;
}

struct Group {
  v1::Case the_case = two_structures();
  std::unique_ptr<MockSolid> hull = follower(1, 0.1, "hull_only"), panel = follower(10, 0.2, "panel_only");
  SolidGroup group{{{.name = "hull", .solid = hull.get()}, {.name = "panel", .solid = panel.get()}}};
  InterfaceLoad load = InterfaceLoad::zero(2, 5);
  InterfaceMotion motion;
  cosurge::Setup setup = group.initialize(the_case, mixed_points(), load, motion);

  Group() {
    load.force.row(0) << 1, 2, 3, 4, 5;
    load.pressure << 10, 20, 30, 40, 50;
  }
  Report advance() { return group.advance({.index = 0, .start = 0, .size = 1e-3}, load, motion); }
};

TEST(SolidGroup, GivesEachItsPointsAndJoinsTheirMotions) {
  Group run;
  EXPECT_EQ(run.motion.displacement, mixed_points().position);
  EXPECT_EQ(run.motion.frequency, 10);
  run.advance();
  EXPECT_EQ(run.motion.velocity, 2 * run.load.force);
  EXPECT_EQ(run.motion.ramp_increment, 3 * run.load.force);
  ASSERT_EQ(run.motion.modes.size(), 2U);
  EXPECT_EQ(run.motion.modes[0].shape.row(0), (Eigen::RowVectorXd(5) << 0, 2, 0, 4, 5).finished());
  EXPECT_EQ(run.motion.modes[1].shape.row(0), (Eigen::RowVectorXd(5) << 1, 0, 3, 0, 0).finished());
  EXPECT_EQ(run.motion.modes[0].load, 20 + 40 + 50);
  EXPECT_EQ(run.motion.modes[1].mobility, 10);
  EXPECT_EQ(run.motion.frequency, 10);
  run.advance();
  EXPECT_EQ(run.motion.modes.size(), 2U);  // those of this window alone
}

TEST(SolidGroup, NumbersTheBodiesOfEachFromZero) {
  Group run;
  std::vector<std::vector<int>> bodies;
  std::vector<Field> places;
  for (MockSolid* solid : {run.hull.get(), run.panel.get()})
    solid->on_initialize = [&](const v1::Case& the_case, const Interface& interface, const InterfaceLoad&,
                               InterfaceMotion& motion) {
      motion = InterfaceMotion::at_rest(2, interface.points());
      bodies.push_back(interface.body);
      places.push_back(interface.position.row(0));
      bodies.push_back({the_case.solid().body_size()});
      return cosurge::Setup{.columns = {}, .particles = 0, .window = 1};
    };
  run.group.initialize(run.the_case, mixed_points(), run.load, run.motion);
  EXPECT_THAT(bodies, ElementsAre(ElementsAre(0, 1, 0), ElementsAre(2), ElementsAre(0, 0), ElementsAre(1)));
  EXPECT_EQ(places.at(0), (Eigen::RowVector3d() << 2, 4, 5).finished());
  EXPECT_EQ(places.at(1), (Eigen::RowVector2d() << 1, 3).finished());
}

TEST(SolidGroup, PutsNamesBeforeColumnsAndNotesAndAddsEnergies) {
  Group run;
  std::vector<std::string> names;
  for (const Column& column : run.setup.columns) names.push_back(column.name);
  EXPECT_THAT(names, ElementsAre("hull/kinetic_energy", "hull/hull_only", "panel/kinetic_energy",
                                 "panel/panel_only", "kinetic_energy"));
  EXPECT_EQ(run.setup.particles, 14U);
  EXPECT_EQ(run.setup.window, 0.1);
  const Report report = run.advance();
  EXPECT_THAT(report.values, ElementsAre(1, 1, 10, 1, 11));
  EXPECT_THAT(report.notes, ElementsAre("hull: moved", "panel: moved"));
  EXPECT_EQ(report.window, 0.1);
}

TEST(SolidGroup, SavesAndRestoresAll) {
  Group run;
  run.advance();
  const std::string state = run.group.save();
  run.advance();
  EXPECT_EQ(run.panel->state[0], 2);
  run.group.restore(state);
  EXPECT_EQ(run.hull->state[0], 1);
  EXPECT_EQ(run.panel->state[0], 1);
  EXPECT_THROW(run.group.restore(state + "x"), Error);
}

/// A frame of one array, with the number of values that are given.
Snapshot frame_with(const std::string& name, const std::vector<float>& values) {
  return {{.name = "solid_position", .unit = "m", .components = 1, .values = {1, 2}},
          {.name = name, .unit = "Pa", .components = 1, .values = values}};
}

class Framed : public MockSolid {
 public:
  Snapshot snapshot;
  Snapshot frame() override { return snapshot; }
};

TEST(SolidGroup, JoinsFramesAndHasZerosWhereOneHasNoSuchArray) {
  Framed hull, panel;
  hull.snapshot = frame_with("solid_a", {5, 6});
  panel.snapshot = frame_with("b", {7, 8});
  SolidGroup group({{.name = "hull", .solid = &hull}, {.name = "panel", .solid = &panel}});
  const Snapshot frame = group.frame();
  ASSERT_EQ(frame.size(), 3U);
  EXPECT_EQ(frame[0].name, "position");
  EXPECT_THAT(frame[0].values, ElementsAre(1, 2, 1, 2));
  EXPECT_THAT(frame[1].values, ElementsAre(5, 6, 0, 0));
  EXPECT_THAT(frame[2].values, ElementsAre(0, 0, 7, 8));
}

TEST(SolidGroup, NamesTheStructureOfAFailureAndKeepsItsKind) {
  Group run;
  run.panel->on_advance = [](const Window&, const InterfaceLoad&, InterfaceMotion&) -> Report {
    throw NumericalError("diverged");
  };
  EXPECT_THAT([&] { run.advance(); }, ThrowsMessage<NumericalError>("panel: diverged"));
  run.panel->on_advance = [](const Window&, const InterfaceLoad&, InterfaceMotion&) -> Report {
    throw Error("no load");
  };
  EXPECT_THAT([&] { run.advance(); }, ThrowsMessage<Error>("panel: no load"));
  run.panel->on_advance = [](const Window&, const InterfaceLoad&, InterfaceMotion&) -> Report {
    throw Interrupted("by hand");
  };
  EXPECT_THAT([&] { run.advance(); }, ThrowsMessage<Interrupted>("by hand"));
}

TEST(SolidGroup, SaysOnceThatTwoStructuresHaveComeIntoOnePlace) {
  Group run;
  run.the_case.mutable_fluid()->set_spacing(0.1);
  const auto move_to = [&](double x) {  // both points of the panel
    run.panel->on_advance = [x](const Window&, const InterfaceLoad&, InterfaceMotion& motion) {
      motion.displacement.row(0).setConstant(x);
      return Report{.values = {0, 0}, .window = 1};
    };
  };
  run.hull->on_advance = [](const Window&, const InterfaceLoad&, InterfaceMotion& motion) {
    motion.displacement.setZero();
    return Report{.values = {0, 0}, .window = 1};
  };
  run.group.initialize(run.the_case, mixed_points(), run.load, run.motion);
  const auto notes = [&](std::uint64_t window) {
    return run.group.advance({.index = window, .start = 0.1, .size = 1e-3}, run.load, run.motion).notes;
  };
  move_to(0.94);  // from 1 to 1.94, beside the hull's point at 2
  EXPECT_THAT(notes(0), ElementsAre());
  move_to(0.96);
  EXPECT_THAT(notes(5), ElementsAre());  // only every tenth window is looked at
  for (int attempt = 0; attempt < 2; ++attempt)
    EXPECT_THAT(notes(10),
                ElementsAre(StartsWith("warning: panel and hull overlap at (1.96, 0) m at t = 0.101 s")));
  EXPECT_THAT(notes(20), ElementsAre());
}

TEST(SolidGroup, IsTheProgramOfAllOrSaysThemAll) {
  Group run;
  EXPECT_EQ(run.group.identity().program, "mock_solid");
  EXPECT_EQ(run.group.identity().version, "0.1.0");
  run.panel->who.program = "mine";
  EXPECT_EQ(run.group.identity().program, "hull: mock_solid 0.1.0, panel: mine 0.1.0");
}

}  // namespace
}  // namespace cosurge
