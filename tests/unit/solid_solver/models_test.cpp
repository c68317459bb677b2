// Common tests of every deformable model with its participant.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "common/error.hpp"
#include "common/vec.hpp"
#include "tests/support/loaded_solid.hpp"

namespace cosurge {
namespace {

using test::l0;
using test::load_of;
using test::LoadedSolid;

/// Every deformable model under every load path.
class Models : public testing::TestWithParam<std::tuple<v1::SolidModel::Word, v1::Coupling::LoadPath>> {
 protected:
  v1::SolidModel::Word model() const { return std::get<0>(GetParam()); }
  v1::Coupling::LoadPath path() const { return std::get<1>(GetParam()); }
  v1::Case scene(const test::SolidParameters& parameters) const {
    v1::Case c = test::plate(parameters);
    c.mutable_coupling()->set_load(path());
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
    const Field before = run.motion.displacement;
    const Field load = load_of(k, 40);
    run.load.force = load;
    const Report report = run.advance(3e-4);
    const Field moved = run.motion.displacement - before;
    const Field first = path() == v1::Coupling::ramped ? last_load : load;
    const Field& late = run.motion.ramp_increment;
    const double work = first.cwiseProduct(moved).sum() + (load - first).cwiseProduct(late).sum();
    at_points += work;
    gross += std::abs(work);
    on_nodes = run.value(report, "interface_work");
    last_load = load;
  }
  EXPECT_GT(gross, 0);
  EXPECT_NEAR(at_points, on_nodes, 1e-12 * gross);  // rounding
}

TEST_P(Models, AnotherAttemptAtAWindowStartsWhereTheFirstDid) {
  const auto after = [&](const std::vector<int>& loads) {
    LoadedSolid run(scene({.rows = 40, .poisson_ratio = 0.3}), test::left_face(40));
    run.load.force = load_of(0, 40);
    run.advance(3e-4);
    Attempt attempt = loads.size() > 1 ? Attempt::first : Attempt::once;
    for (const int load : loads) {
      run.load.force = load_of(load, 40);
      run.solid.advance({.index = 1, .start = 3e-4, .size = 3e-4, .attempt = attempt}, run.load, run.motion);
      attempt = Attempt::again;
    }
    return run.solid.save();
  };
  EXPECT_EQ(after({4}), after({2, 3, 4}));
  EXPECT_NE(after({4}), after({3}));
}

TEST_P(Models, TheVelocityIsTheMeanOrThatAtTheEnd) {
  v1::Case c = scene({.rows = 40, .poisson_ratio = 0.3});
  const auto run = [&](v1::Coupling::Velocity choice, double size) {
    c.mutable_coupling()->set_velocity(choice);
    auto loaded = std::make_unique<LoadedSolid>(c, test::left_face(40));
    for (int k = 0; k < 5; ++k) {
      loaded->load.force = load_of(k, 40);
      loaded->advance(size);
    }
    return loaded;
  };
  const auto mean = run(v1::Coupling::mean, 3e-4);
  const auto end = run(v1::Coupling::end, 3e-4);
  EXPECT_EQ(mean->motion.displacement, end->motion.displacement);
  // Under no load in a window that is short against every motion, both are the same velocity.
  for (auto* loaded : {mean.get(), end.get()}) {
    loaded->load.force.setZero();
    loaded->advance(1e-9);
  }
  const double scale = end->motion.velocity.norm();
  EXPECT_GT(scale, 0);
  // The displacement of some 1e-5 m is known to 1e-21 m, and divided by 1e-9 s; the stiffest acceleration,
  // some 1e4 m/s2 at 1e-2 m/s, and what is left of a ramp change the velocity by 1e-5 of itself.
  EXPECT_LT((mean->motion.velocity - end->motion.velocity).norm(), 1e-3 * scale);
}

TEST_P(Models, WorkIsTheChangeOfEnergy) {
  v1::Case c = scene({.rows = 40, .poisson_ratio = 0.3});
  c.mutable_solid()->mutable_fem()->set_rho_infinity(1);  // no damping
  c.mutable_solid()->mutable_mps()->set_viscosity(0);
  c.mutable_solid()->mutable_hamiltonian()->set_viscosity(0);
  LoadedSolid run(c, test::left_face(40));
  double gross = 0, work = 0, energy = 0;
  for (int k = 0; k < 40; ++k) {
    // Slow against the sub-steps; no load at the end, where the scheme's energy equals the body's.
    run.load.force =
        k < 39 ? Field(0.02 * std::sin(0.08 * k) * Field::Ones(2, 40)) : Field(Field::Zero(2, 40));
    const Report report = run.advance(2e-4);
    const double now = run.value(report, "interface_work");
    gross += std::abs(now - work);
    work = now;
    energy = run.value(report, "kinetic_energy") + run.value(report, "elastic_energy");
  }
  // mps, hamiltonian: the work in a step uses the mean of two half steps' motion; its error is dt / 2 times
  // the change of the load's power: 1e-5 s of 1e-2 s. fem: the mid-point rule, exact except for nonlinear
  // terms. modal: exact except for rounding.
  const bool particles = model() == v1::SolidModel::mps || model() == v1::SolidModel::hamiltonian;
  const double off = particles ? 2e-3 : model() == v1::SolidModel::fem ? 1e-5 : 1e-12;
  EXPECT_NEAR(energy, work, off * gross);
}

TEST_P(Models, SavedStateContinuesBitForBit) {
  const v1::Case c = scene({.rows = 20});
  LoadedSolid run(c, test::left_face(20));
  for (int k = 0; k < 5; ++k) {
    run.load.force = load_of(k, 20);
    run.advance(1e-4);
  }
  const std::string state = run.solid.save();
  const auto five_more = [](LoadedSolid& r) {
    for (int k = 5; k < 10; ++k) {
      r.load.force = load_of(k, 20);
      r.advance(1e-4);
    }
    return r.motion;
  };
  const InterfaceMotion straight = five_more(run);
  LoadedSolid other(c, test::left_face(20));
  other.solid.restore(state);
  const InterfaceMotion resumed = five_more(other);
  run.solid.restore(state);
  const InterfaceMotion again = five_more(run);
  for (const InterfaceMotion* motion : {&resumed, &again}) {
    EXPECT_TRUE((motion->displacement.array() == straight.displacement.array()).all());
    EXPECT_TRUE((motion->velocity.array() == straight.velocity.array()).all());
    EXPECT_TRUE((motion->ramp_increment.array() == straight.ramp_increment.array()).all());
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
    run.load.force = -1e4 * points.area;
    run.advance(5e-5);
    momentum += run.motion.velocity.rowwise().sum();
    gross += run.motion.velocity.cwiseAbs().sum();
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
  run.load.force.setConstant(0.001);
  run.advance(1e-4);
  run.load.force.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(run.advance(1e-4), NumericalError);
}

/// Frequency [Hz] and logarithm of the decay over a period, from the swings of the tip after a push.
struct Swing {
  double frequency, decrement;
};

Swing swing_of(const v1::Case& c, double frequency, const Field& push, const Interface& points) {
  LoadedSolid run(c, points);
  constexpr int period = 100;  // windows
  const double window = 1 / (period * frequency);
  std::vector<double> rises, peaks;
  double before = 0, highest = 0;
  for (int k = 0; k < 5 * period; ++k) {
    // A pulse as long as a period, which leaves the higher modes alone.
    run.load.force = (k < period ? std::pow(std::sin(std::acos(-1.0) * k / period), 2) : 0.0) * push;
    const double tip = run.value(run.advance(window), "tip_x");
    if (k > period && before < 0 && tip >= 0) {
      rises.push_back((k - tip / (tip - before)) * window);
      if (rises.size() > 1) peaks.push_back(highest);
      highest = 0;
    }
    highest = std::max(highest, tip);
    before = tip;
  }
  return {.frequency = static_cast<double>(rises.size() - 1) / (rises.back() - rises.front()),
          .decrement = std::log(peaks.front() / peaks.back()) / static_cast<double>(peaks.size() - 1)};
}

class Words : public testing::TestWithParam<v1::SolidModel::Word> {
 protected:
  v1::Case scene(const test::SolidParameters& parameters) const {
    v1::Case c = test::plate(parameters);
    c.mutable_solid()->set_model(GetParam());
    c.mutable_solid()->mutable_fem()->set_rho_infinity(1);
    c.mutable_coupling()->set_load(v1::Coupling::ramped);
    return c;
  }
};

Field sideways(Eigen::Index points, double force) {
  Field push = Field::Zero(2, points);
  push.row(0).setConstant(force);
  return push;
}

TEST_P(Words, DampingRatioIsThatOfTheFirstMode) {
  v1::Case c = scene({.columns = 6, .rows = 30});
  c.mutable_solid()->set_damping_ratio(0.02);
  const Swing swing = swing_of(c, 21.2, sideways(30, 1e-4), test::left_face(30));
  const double exact = 2 * std::acos(-1.0) * 0.02 / std::sqrt(1 - 0.02 * 0.02);
  // The rate is from the elements' first frequency, which particles are off by up to 6 %; second mode 1 % of
  // the peaks.
  EXPECT_NEAR(swing.decrement / exact, 1, 0.08);
}

TEST_P(Words, AFreeBodyHasNoDampingRatio) {
  v1::Case c = scene({.rows = 20, .clamped = false});
  c.mutable_solid()->set_damping_ratio(0.02);
  EXPECT_THROW(LoadedSolid(c, {}), Error);
}

TEST_P(Words, APlateInPlaneStressIsSofterThanInPlaneStrain) {
  v1::Case c = scene({.columns = 6, .rows = 30, .poisson_ratio = 0.4});
  const double strain = swing_of(c, 23.2, sideways(30, 1e-4), test::left_face(30)).frequency;
  c.mutable_solid()->set_plane(v1::Solid::plane_stress);
  const double stress = swing_of(c, 21.2, sideways(30, 1e-4), test::left_face(30)).frequency;
  // sqrt(1 - nu^2) of a slender beam; thickness over length 0.2, and a clamp that hinders contraction: 2 %.
  EXPECT_NEAR(stress / strain / std::sqrt(1 - 0.16), 1, 0.03);
}

/// A beam of 11 x 80 mm on a hinge at one end and a roller at the other, both on its axis.
TEST_P(Words, ABeamOnHingesSwingsAsTheoryHasIt) {
  v1::Case c = scene({.columns = 11, .rows = 81, .clamped = false, .young_modulus = 1e6});
  v1::Body& body = *c.mutable_solid()->mutable_body(0);
  c.mutable_solid()->mutable_fem()->set_element(0.0055);
  // On the particles' sites and the elements' nodes alike: half a spacing wide.
  v1::Support &hinge = *body.add_support(), &roller = *body.add_support();
  test::set_box(*hinge.mutable_box(), {0.0054, 0}, {0.0056, 0.0006});
  test::set_box(*roller.mutable_box(), {0.0054, 0.0804}, {0.0056, 0.081});
  roller.add_along(v1::Axis::x);
  v1::Probe& middle = *c.mutable_output()->mutable_probe(0);
  middle.set_position(0, 0.0055);
  middle.set_position(1, 0.0405);
  const bool particles = GetParam() == v1::SolidModel::mps || GetParam() == v1::SolidModel::hamiltonian;
  // Particles are held in the middle of their cells.
  const double length = particles ? 0.080 : 0.081, h = 0.011, k = std::acos(-1.0) / length;
  // Timoshenko: rho A w^2 = E I k^4 / (1 + k^2 (I / A) (1 + E / (5/6 G))), nu = 0.
  const double slender = k * k * h * h / 12,
               exact = k * k * std::sqrt(1e6 * h * h / 12 / 2500 / (1 + slender * (1 + 2.4))) /
                       (2 * std::acos(-1.0));
  const Swing swing = swing_of(c, exact, sideways(81, 1e-4), test::left_face(81));
  RecordProperty("over_theory", fmt::format("{:.4f}", swing.frequency / exact));
  EXPECT_NEAR(swing.frequency / exact, 1, 0.03);  // a point that is held gives way by its own dent
}

TEST_P(Words, SeveralBodiesMoveAsTheyDoAlone) {
  // Two plates of different height, the second one free; a load on the first, and on the second a third
  // later.
  const auto interface_of = [](std::vector<int> bodies) {
    Interface points{.dimension = 2, .position = Field(2, 0), .area = Field(), .body = {}};
    for (std::size_t which = 0; which < bodies.size(); ++which) {
      const Interface face = test::left_face(20);
      Field moved = face.position;
      moved.row(0).array() += 0.03 * bodies[which];
      const Eigen::Index before = points.points();
      points.position.conservativeResize(2, before + 20);
      points.position.rightCols(20) = moved;
      points.body.insert(points.body.end(), 20, static_cast<int>(which));
    }
    points.area = Field::Zero(2, points.points());
    return points;
  };
  const v1::Case first = scene({.columns = 6, .rows = 20, .poisson_ratio = 0.3});
  v1::Case second = first, both = first;
  v1::Body& other = *second.mutable_solid()->mutable_body(0);
  other.clear_clamp();
  test::set_box(*other.mutable_box(), {0.03, 0}, {0.036, 0.03});
  second.mutable_output()->clear_probe();
  *both.mutable_solid()->add_body() = other;
  LoadedSolid alone(first, interface_of({0})), alone_too(second, interface_of({1})),
      together(both, interface_of({0, 1}));
  double work = 0;
  for (int k = 0; k < 10; ++k) {
    alone.load.force = load_of(k, 20);
    alone_too.load.force = load_of(k / 3, 20);
    together.load.force = Field(2, 40);
    together.load.force << alone.load.force, alone_too.load.force;
    const Report one = alone.advance(1e-4), two = alone_too.advance(1e-4), sum = together.advance(1e-4);
    work = together.value(sum, "interface_work");
    EXPECT_NEAR(work, alone.value(one, "interface_work") + alone_too.value(two, "interface_work"),
                1e-12 * work);
  }
  EXPECT_GT(work, 0);
  Field each(2, 40);
  each << alone.motion.displacement, alone_too.motion.displacement;
  // Bit-identical except for `hamiltonian`, whose stable step is that of the stiffest body.
  EXPECT_LT((together.motion.displacement - each).cwiseAbs().maxCoeff(), 1e-3 * each.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(All, Words,
                         testing::Values(v1::SolidModel::mps, v1::SolidModel::hamiltonian,
                                         v1::SolidModel::fem, v1::SolidModel::modal),
                         [](const auto& choice) { return v1::SolidModel::Word_Name(choice.param); });

INSTANTIATE_TEST_SUITE_P(All, Models,
                         testing::Combine(testing::Values(v1::SolidModel::mps, v1::SolidModel::hamiltonian,
                                                          v1::SolidModel::fem, v1::SolidModel::modal),
                                          testing::Values(v1::Coupling::held, v1::Coupling::ramped)),
                         [](const auto& choice) {
                           return v1::SolidModel::Word_Name(std::get<0>(choice.param)) + "_" +
                                  v1::Coupling::LoadPath_Name(std::get<1>(choice.param));
                         });

}  // namespace
}  // namespace cosurge
