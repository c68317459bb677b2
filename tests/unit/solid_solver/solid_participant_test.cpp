#include "solid_solver/solid_participant.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"
#include "common/vec.hpp"
#include "tests/support/loaded_solid.hpp"

namespace cosurge {
namespace {

using test::l0;
using test::load_of;
using test::LoadedSolid;

v1::Case coupled(const test::SolidParameters& parameters, v1::Coupling::LoadPath path) {
  v1::Case c = test::plate(parameters);
  c.mutable_coupling()->set_load(path);
  return c;
}

TEST(SolidParticipant, ImpulseOfARampIsTheMeanOfItsEnds) {
  LoadedSolid run(coupled({.rows = 8, .clamped = false}, v1::Coupling::ramped), test::left_face(8));
  const double window = 1e-3, first = 0.01, last = 0.03;
  const double mass = 12 * 8 * l0 * l0 * 2500;
  run.load.force.row(0).setConstant(first / 8);
  run.advance(window);  // from zero
  run.load.force.row(0).setConstant(last / 8);
  run.advance(window);
  const double impulse = (first / 2 + (first + last) / 2) * window;
  Snapshot frame = run.solid.frame();
  double momentum = 0;
  for (std::size_t k = 0; k < frame[1].values.size(); k += 2)
    momentum += static_cast<double>(frame[1].values[k]) * mass / (12 * 8);
  EXPECT_NEAR(momentum / impulse, 1, 1e-6);  // frames are single precision
}

TEST(SolidParticipant, PointsOnTheLatticeFollowTheirParticleAlone) {
  const v1::Case c = test::plate({.rows = 20});
  LoadedSolid run(c, test::left_face(20));
  run.load.force = load_of(1, 20);
  run.advance(1e-3);
  const Snapshot frame = run.solid.frame();
  for (int j = 0; j < 20; ++j) {
    const auto particle = static_cast<std::size_t>(24 + 12 * j);  // after two held rows
    const double x = 0.5 * l0 + run.motion.displacement(0, j);
    EXPECT_FLOAT_EQ(frame[0].values[2 * particle], static_cast<float>(x));
  }
}

TEST(SolidParticipant, PointsFollowTheirOwnBodyOnly) {
  v1::Case c = test::plate({.columns = 4, .rows = 20});
  v1::Body& second = *c.mutable_solid()->add_body();
  test::set_box(*second.mutable_box(), {4 * l0, 0}, {8 * l0, 20 * l0});  // touches the first
  test::set_box(*second.add_clamp(), {4 * l0, -4 * l0}, {8 * l0, 0});
  Interface points{.dimension = 2, .position = Field(2, 2), .area = Field::Zero(2, 2), .body = {0, 1}};
  points.position << 4 * l0, 4 * l0, 19.5 * l0, 19.5 * l0;  // one place, two bodies
  LoadedSolid run(c, points);
  run.load.force = Field::Zero(2, 2);
  run.load.force(0, 1) = 0.001;
  run.advance(5e-3);
  EXPECT_EQ(run.motion.displacement(0, 0), 0);
  EXPECT_GT(run.motion.displacement(0, 1), 0);
}

TEST(SolidParticipant, VelocityIsTheMeanOverTheWindow) {
  LoadedSolid run(test::plate({.rows = 20}), test::left_face(20));
  run.load.force = load_of(1, 20);
  run.advance(1e-3);
  const Field before = run.motion.displacement;
  run.advance(7e-4);
  const Field mean = (run.motion.displacement - before) / 7e-4;
  EXPECT_LT((run.motion.velocity - mean).cwiseAbs().maxCoeff(),
            1e-12);  // rounding of displacements over 7e-4 s
}

TEST(SolidParticipant, SubStepsStayBelowTheStableStep) {
  v1::Case c = test::plate({.rows = 20});
  const double viscous = LoadedSolid(c, {}).setup.substep / 0.7;
  c.mutable_solid()->mutable_mps()->set_viscosity(0);
  LoadedSolid run(c, {});
  const double stable = run.setup.substep / 0.7;
  // (S40), (S41): by default tau = 0.2 l0 / c_p, c_p = 20 m/s, and omega_max = 2 / stable.
  const double ratio = 0.2 * l0 / 20 / stable;
  EXPECT_NEAR(viscous / stable, std::sqrt(1 + ratio * ratio) - ratio, 1e-12);
  // Frequency of the rotations in the infinite lattice; springs with a body's own weights are up to 7 %
  // faster.
  const double lattice = 2 / std::sqrt(24.0) * l0 / std::sqrt(1e6 / 2 / 2500);
  EXPECT_LE(stable / lattice, 1);
  EXPECT_GE(stable / lattice, 0.93);
  const double window = 10.001 * run.setup.substep;
  EXPECT_EQ(run.value(run.advance(window), "substeps"), 11);
  EXPECT_EQ(run.value(run.advance(10 * run.setup.substep), "substeps"), 10);

  c.mutable_solid()->mutable_mps()->set_substep(1.01 * stable);
  EXPECT_THROW(LoadedSolid(c, {}), Error);
  c.mutable_solid()->mutable_mps()->set_substep(1e-6);
  EXPECT_EQ(LoadedSolid(c, {}).value(LoadedSolid(c, {}).advance(2e-5), "substeps"), 20);
}

TEST(SolidParticipant, SpacingIsTheFluidsWhereItHasNone) {
  v1::Case c = test::plate({.rows = 20});
  c.mutable_solid()->clear_spacing();
  EXPECT_THROW(LoadedSolid(c, {}), Error);
  c.mutable_fluid()->set_spacing(0.002);
  EXPECT_EQ(LoadedSolid(c, {}).setup.particles, 6u * (10 + 2));
}

TEST(SolidParticipant, RunawayMotionSaysWhereAndWhen) {
  LoadedSolid run(test::plate({.rows = 20}), test::left_face(20));
  run.advance(1e-4);
  run.load.force.setConstant(std::numeric_limits<double>::quiet_NaN());
  try {
    run.advance(1e-4);
    FAIL() << "went on";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("t = 0.0001 s"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("particle"), std::string::npos);
  }
}

TEST(SolidParticipant, ProbesOutsideEveryBodyAreRefused) {
  v1::Case c = test::plate({.rows = 20});
  c.mutable_output()->mutable_probe(0)->set_position(1, 0.021);
  EXPECT_THROW(LoadedSolid(c, {}), Error);
}

TEST(SolidParticipant, ForeignStatesAreRefused) {
  LoadedSolid small(test::plate({.rows = 10}), {}), large(test::plate({.rows = 20}), {});
  EXPECT_THROW(large.solid.restore(small.solid.save()), Error);
  EXPECT_THROW(small.solid.restore(large.solid.save()), Error);
}

TEST(RigidModel, StandsStillAndReportsItsLoad) {
  v1::Case c = test::plate({.rows = 20});
  c.mutable_solid()->set_model(v1::SolidModel::rigid);
  LoadedSolid run(c, test::left_face(20));
  run.load.force.setConstant(2.5);
  const Report report = run.advance(1e-3);
  EXPECT_EQ(run.value(report, "load_x"), 50);
  EXPECT_EQ(run.value(report, "tip_x"), 0);
  EXPECT_EQ(run.value(report, "interface_work"), 0);
  EXPECT_EQ(run.motion.displacement.cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(run.motion.velocity.cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(run.solid.frame()[0].values.size(), 2u * 12 * 20);
}

}  // namespace
}  // namespace cosurge
