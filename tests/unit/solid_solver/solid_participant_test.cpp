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

/// Every deformable model under every load path.
class Models : public testing::TestWithParam<std::tuple<v1::SolidModel::Word, v1::Coupling::LoadPath>> {
 protected:
  v1::SolidModel::Word model() const { return std::get<0>(GetParam()); }
  v1::Coupling::LoadPath path() const { return std::get<1>(GetParam()); }
  v1::Case scene(const test::SolidParameters& parameters) const {
    v1::Case c = coupled(parameters, path());
    c.mutable_solid()->set_model(model());
    return c;
  }
};

TEST_P(Models, WorkAtThePointsIsTheWorkOnTheNodes) {
  // Points off the lattice, so that H spreads every load over many nodes.
  Interface points = test::left_face(40);
  points.position.row(0).array() -= 0.3 * l0;
  LoadedSolid run(scene({.rows = 40, .poisson_ratio = 0.3}), points);
  double at_points = 0, gross = 0, on_nodes = 0;
  Field last_load = Field::Zero(2, 40);
  for (int k = 0; k < 30; ++k) {
    const Field before = run.surface.displacement;
    const Field load = load_of(k, 40);
    run.surface.force = load;
    const Report report = run.advance(3e-4);
    const Field moved = run.surface.displacement - before;
    const Field first = path() == v1::Coupling::ramped ? last_load : load;
    const Field& late = run.surface.ramp_increment;
    const double work = first.cwiseProduct(moved).sum() + (load - first).cwiseProduct(late).sum();
    at_points += work;
    gross += std::abs(work);
    on_nodes = run.value(report, "interface_work");
    last_load = load;
  }
  EXPECT_GT(gross, 0);
  EXPECT_NEAR(at_points, on_nodes, 1e-12 * gross);  // rounding
}

TEST_P(Models, WorkIsTheChangeOfEnergy) {
  v1::Case c = scene({.rows = 40, .poisson_ratio = 0.3});
  c.mutable_solid()->mutable_fem()->set_rho_infinity(1);  // no damping
  LoadedSolid run(c, test::left_face(40));
  double gross = 0, work = 0, energy = 0;
  for (int k = 0; k < 40; ++k) {
    // Slow against the sub-steps; no load at the end, where the scheme's energy is that of the body alone.
    run.surface.force =
        k < 39 ? Field(0.02 * std::sin(0.08 * k) * Field::Ones(2, 40)) : Field(Field::Zero(2, 40));
    const Report report = run.advance(2e-4);
    const double now = run.value(report, "interface_work");
    gross += std::abs(now - work);
    work = now;
    energy = run.value(report, "kinetic_energy") + run.value(report, "elastic_energy");
  }
  // mps: the work in a step is that of the load on the mean of two half steps' motion, and off by dt / 2
  // times the change of the load's power: 1e-5 s of 1e-2 s. fem: the mid-point rule, exact but for what is
  // not linear. modal: exact but for rounding.
  const double off = model() == v1::SolidModel::mps ? 2e-3 : model() == v1::SolidModel::fem ? 1e-5 : 1e-12;
  EXPECT_NEAR(energy, work, off * gross);
}

TEST_P(Models, SavedStateContinuesBitForBit) {
  const v1::Case c = scene({.rows = 20});
  LoadedSolid run(c, test::left_face(20));
  for (int k = 0; k < 5; ++k) {
    run.surface.force = load_of(k, 20);
    run.advance(1e-4);
  }
  const std::string state = run.solid.save();
  const auto five_more = [](LoadedSolid& r) {
    for (int k = 5; k < 10; ++k) {
      r.surface.force = load_of(k, 20);
      r.advance(1e-4);
    }
    return r.surface;
  };
  const Surface straight = five_more(run);
  LoadedSolid other(c, test::left_face(20));
  other.solid.restore(state);
  const Surface resumed = five_more(other);
  run.solid.restore(state);
  const Surface again = five_more(run);
  for (const Surface* surface : {&resumed, &again}) {
    EXPECT_TRUE((surface->displacement.array() == straight.displacement.array()).all());
    EXPECT_TRUE((surface->velocity.array() == straight.velocity.array()).all());
    EXPECT_TRUE((surface->ramp_increment.array() == straight.ramp_increment.array()).all());
  }
}

TEST_P(Models, UniformPressureAllAroundMovesNothing) {
  const int columns = 12, rows = 20;
  v1::Case c = scene({.columns = columns, .rows = rows, .clamped = false});
  Interface points{.dimension = 2, .position = Field(2, columns * rows), .area = {}, .body = {}};
  points.area = Field::Zero(2, columns * rows);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int p = j * columns + i;
      points.position.col(p) << (i + 0.5) * l0, (j + 0.5) * l0;
      points.area.col(p) << l0 * ((i == columns - 1) - (i == 0)), l0 * ((j == rows - 1) - (j == 0));
    }
  }
  points.body.assign(columns * rows, 0);
  LoadedSolid run(c, points);
  Vec<2> momentum = Vec<2>::Zero();
  double gross = 0;
  for (int k = 0; k < 20; ++k) {
    run.surface.force = -1e4 * points.area;
    run.advance(5e-5);
    momentum += run.surface.velocity.rowwise().sum();
    gross += run.surface.velocity.cwiseAbs().sum();
  }
  ASSERT_GT(gross, 0);
  // The motion is symmetric, so that the sum over the lattice is zero as the momentum is; rounding of
  // displacements over 5e-5 s.
  EXPECT_LT(momentum.norm(), 1e-9 * gross);
}

TEST_P(Models, FramesShowTheLatticeWhateverTheModel) {
  LoadedSolid run(scene({.columns = 4, .rows = 10, .clamped = false}), test::left_face(10));
  const Snapshot frame = run.solid.frame();
  EXPECT_EQ(run.setup.particles, 40u);
  ASSERT_EQ(frame.size(), 3u);
  EXPECT_EQ(frame[2].values.size(), 40u);
  EXPECT_FLOAT_EQ(frame[0].values[2 * 39], 3.5e-3f);
  EXPECT_FLOAT_EQ(frame[0].values[2 * 39 + 1], 9.5e-3f);
}

TEST_P(Models, LoadsThatAreNoNumbersEndTheRun) {
  LoadedSolid run(scene({.rows = 20}), test::left_face(20));
  run.surface.force.setConstant(0.001);
  run.advance(1e-4);
  run.surface.force.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(run.advance(1e-4), NumericalError);
}

INSTANTIATE_TEST_SUITE_P(All, Models,
                         testing::Combine(testing::Values(v1::SolidModel::mps, v1::SolidModel::fem,
                                                          v1::SolidModel::modal),
                                          testing::Values(v1::Coupling::held, v1::Coupling::ramped)),
                         [](const auto& choice) {
                           return v1::SolidModel::Word_Name(std::get<0>(choice.param)) + "_" +
                                  v1::Coupling::LoadPath_Name(std::get<1>(choice.param));
                         });

TEST(SolidParticipant, ImpulseOfARampIsTheMeanOfItsEnds) {
  LoadedSolid run(coupled({.rows = 8, .clamped = false}, v1::Coupling::ramped), test::left_face(8));
  const double window = 1e-3, first = 0.01, last = 0.03;
  const double mass = 12 * 8 * l0 * l0 * 2500;
  run.surface.force.row(0).setConstant(first / 8);
  run.advance(window);  // from zero
  run.surface.force.row(0).setConstant(last / 8);
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
  run.surface.force = load_of(1, 20);
  run.advance(1e-3);
  const Snapshot frame = run.solid.frame();
  for (int j = 0; j < 20; ++j) {
    const auto particle = static_cast<std::size_t>(24 + 12 * j);  // after two held rows
    const double x = 0.5 * l0 + run.surface.displacement(0, j);
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
  run.surface.force = Field::Zero(2, 2);
  run.surface.force(0, 1) = 0.001;
  run.advance(5e-3);
  EXPECT_EQ(run.surface.displacement(0, 0), 0);
  EXPECT_GT(run.surface.displacement(0, 1), 0);
}

TEST(SolidParticipant, VelocityIsTheMeanOverTheWindow) {
  LoadedSolid run(test::plate({.rows = 20}), test::left_face(20));
  run.surface.force = load_of(1, 20);
  run.advance(1e-3);
  const Field before = run.surface.displacement;
  run.advance(7e-4);
  const Field mean = (run.surface.displacement - before) / 7e-4;
  EXPECT_LT((run.surface.velocity - mean).cwiseAbs().maxCoeff(),
            1e-12);  // rounding of displacements over 7e-4 s
}

TEST(SolidParticipant, SubStepsStayBelowTheStableStep) {
  v1::Case c = test::plate({.rows = 20});
  LoadedSolid run(c, {});
  const double stable = 2 / std::sqrt(24.0) * l0 / std::sqrt(1e6 / 2 / 2500);
  EXPECT_NEAR(run.setup.substep / (0.7 * stable), 1, 1e-12);  // the same formula
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
  run.surface.force.setConstant(std::numeric_limits<double>::quiet_NaN());
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
  run.surface.force.setConstant(2.5);
  const Report report = run.advance(1e-3);
  EXPECT_EQ(run.value(report, "load_x"), 50);
  EXPECT_EQ(run.value(report, "tip_x"), 0);
  EXPECT_EQ(run.value(report, "interface_work"), 0);
  EXPECT_EQ(run.surface.displacement.cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(run.surface.velocity.cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(run.solid.frame()[0].values.size(), 2u * 12 * 20);
}

}  // namespace
}  // namespace cosurge
