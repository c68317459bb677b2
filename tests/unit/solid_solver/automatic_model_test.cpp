#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "solid_solver/models/automatic/linear_theory.hpp"
#include "tests/support/loaded_solid.hpp"
#include "tests/support/structures.hpp"

namespace cosurge {
namespace {

using test::l0;
using test::LoadedSolid;

constexpr double h = 5e-4;   // window [s]
constexpr double f1 = 5.97;  // first frequency of the plate [Hz]
constexpr int rows = 80;

/// Pressure [Pa] on the face of the plate at a time and height, as a share of the plate's length.
using Pressure = std::function<double(double time, double height)>;

v1::Case plate(v1::SolidModel::Word model, double damping_ratio = 0) {
  v1::Case c = test::plate({});
  c.mutable_solid()->set_model(model);
  c.mutable_coupling()->set_load(v1::Coupling::ramped);
  c.mutable_solid()->mutable_fem()->set_rho_infinity(1);
  c.mutable_solid()->set_damping_ratio(damping_ratio);
  return c;
}

/// A plate under a pressure, window after window.
struct LoadedPlate {
  LoadedSolid solid;
  Pressure pressure;
  Report report = {};
  std::vector<std::string> notes = {};

  LoadedPlate(const v1::Case& c, Pressure of_face)
      : solid(c, test::left_face(rows)), pressure(std::move(of_face)) {}

  double advance() {
    for (int j = 0; j < rows; ++j)
      solid.load.force.col(j) << l0 * pressure(solid.time + h, (j + 0.5) / rows), 0;
    report = solid.advance(h);
    notes.insert(notes.end(), report.notes.begin(), report.notes.end());
    return value("tip_x");
  }
  double value(const std::string& column) const { return solid.value(report, column); }
  std::vector<double> tip(int windows) {
    std::vector<double> history;
    for (int k = 0; k < windows; ++k) history.push_back(advance());
    return history;
  }
};

double largest(const std::vector<double>& history) {
  double most = 0;
  for (const double value : history) most = std::max(most, std::abs(value));
  return most;
}

/// Largest difference over the largest value.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most / largest(b);
}

double pulse(double t, double start, double length) {
  const double s = (t - start) / length;
  return s > 0 && s < 1 ? std::pow(std::sin(std::numbers::pi * s), 2) : 0;
}

TEST(LinearTheory, EstimatesTheNonlinearDeflection) {
  // A plate that is clamped at both ends stretches when it bends: (w / t)^2 of its stiffness.
  v1::Case c = test::plate({.columns = 6, .rows = 80});
  test::set_box(*c.mutable_solid()->mutable_body(0)->add_clamp(), {0, 0.08}, {0.006, 0.1});
  const Elasticity material{.density = 2500, .young_modulus = 1e6, .poisson_ratio = 0};
  const fem::FemBody<2> body(test::body_of<2>(c.solid().body(0)), 0, 0, material, Vec<2>(20, 0));
  const automatic::LinearTheory<2> theory(body);
  for (const double factor : {0.5, 1.0, 2.0}) {
    const fem::Vector force = factor * body.weight();
    const fem::Vector u = theory.deflection(force);
    const std::optional<fem::Vector> exact = theory.nonlinear(u);
    ASSERT_TRUE(exact);
    const double left = (force - body.internal_force(*exact).force).lpNorm<Eigen::Infinity>();
    EXPECT_LT(left, 1e-3 * force.lpNorm<Eigen::Infinity>());
    const double real = (*exact - u).lpNorm<Eigen::Infinity>() / u.lpNorm<Eigen::Infinity>();
    const double estimate = theory.correction(u).lpNorm<Eigen::Infinity>() / u.lpNorm<Eigen::Infinity>();
    RecordProperty(fmt::format("real_{}", factor), fmt::format("{:.4f} {:.4f}", real, estimate));
    EXPECT_GT(estimate, real);
    EXPECT_LT(estimate, 5 * real);
    if (factor == 1.0) {
      // w = q L^4 / (384 E I); with immovable ends the deflection in the middle decreases by about 0.5 (w /
      // t)^2 of itself (Timoshenko, Theory of Plates and Shells, art. 97: long rectangular plates).
      const double w = 2500 * 20 * 0.006 * std::pow(0.08, 4) / (384 * 1e6 * std::pow(0.006, 3) / 12);
      EXPECT_NEAR(real, 0.5 * std::pow(w / 0.006, 2), 0.03);
    }
  }
}

TEST(LinearTheory, HasNoNonlinearDisplacementWhereTheBodyCollapses) {
  const v1::Case c = test::plate({.columns = 6, .rows = 80});
  const Elasticity material{.density = 2500, .young_modulus = 1e6, .poisson_ratio = 0};
  const fem::FemBody<2> body(test::body_of<2>(c.solid().body(0)), 0, 0, material, Vec<2>(0, -1e5));
  const automatic::LinearTheory<2> theory(body);
  EXPECT_FALSE(theory.nonlinear(theory.deflection(body.weight())));
}

TEST(AutomaticModel, IsModalToTheBitWhileDeflectionIsSmall) {
  const Pressure weak = [](double t, double) { return 6 * pulse(t, 0, 0.04); };
  LoadedPlate ours(plate(v1::SolidModel::auto_), weak), modes(plate(v1::SolidModel::modal), weak);
  for (int k = 0; k < 400; ++k) {
    ASSERT_EQ(ours.advance(), modes.advance()) << k;
    ASSERT_EQ(ours.value("model"), 0);
  }
  EXPECT_TRUE(ours.notes.empty());
  EXPECT_GT(ours.value("nonlinearity"), 0);
  EXPECT_LT(ours.value("nonlinearity"), 0.02);
}

TEST(AutomaticModel, ComputesALargeDeflectionByElements) {
  const Pressure strong = [](double t, double) { return 400 * pulse(t, 0, 0.08); };
  LoadedPlate ours(plate(v1::SolidModel::auto_), strong), elements(plate(v1::SolidModel::fem), strong);
  const auto tip = ours.tip(600), reference = elements.tip(600);
  RecordProperty("tip", fmt::format("{:.4g} {:.4g}", largest(tip), difference(tip, reference)));
  ASSERT_GT(largest(reference), 0.01);
  EXPECT_LT(difference(tip, reference), 0.02);
  EXPECT_EQ(ours.value("model"), 1);
  ASSERT_EQ(ours.notes.size(), 1U);
  EXPECT_NE(ours.notes[0].find("the deflection is no longer small"), std::string::npos) << ours.notes[0];
}

TEST(AutomaticModel, ComesBackToModesAndLeavesThemAtASecondImpact) {
  // With damping the plate is almost at rest again a second after the first impact.
  const Pressure twice = [](double t, double) { return 100 * pulse(t, 0, 0.08) + 150 * pulse(t, 2, 0.05); };
  LoadedPlate ours(plate(v1::SolidModel::auto_, 0.2), twice),
      elements(plate(v1::SolidModel::fem, 0.2), twice);
  std::vector<double> tip, reference, model;
  for (int k = 0; k < 5000; ++k) {
    tip.push_back(ours.advance());
    reference.push_back(elements.advance());
    model.push_back(ours.value("model"));
  }
  EXPECT_EQ(model[200], 1);
  EXPECT_EQ(model[3900], 0);
  EXPECT_EQ(model[4200], 1);
  EXPECT_EQ(ours.notes.size(), model.back() == 1 ? 3U : 4U);
  RecordProperty("difference", fmt::format("{:.4g}", difference(tip, reference)));
  EXPECT_LT(difference(tip, reference), 0.02);
}

TEST(AutomaticModel, ComputesByElementsWhereModesAreNotEnough) {
  // On a tenth of the plate above the foot: most of the deflection there is local.
  const Pressure local = [](double, double height) { return height < 0.1 ? 5.0 : 0.0; };
  LoadedPlate ours(plate(v1::SolidModel::auto_), local);
  const auto windows = static_cast<int>(1 / (f1 * h));
  ours.tip(windows - 2);
  EXPECT_EQ(ours.value("model"), 0);
  EXPECT_GT(ours.value("truncation"), 0.02);
  ours.tip(5);
  EXPECT_EQ(ours.value("model"), 1);
  ASSERT_FALSE(ours.notes.empty());
  EXPECT_NE(ours.notes[0].find("modes are not enough"), std::string::npos) << ours.notes[0];
}

TEST(AutomaticModel, FollowsALoadAtANaturalFrequency) {
  const Pressure resonant = [](double t, double) { return 4 * std::sin(2 * std::numbers::pi * f1 * t); };
  LoadedPlate ours(plate(v1::SolidModel::auto_), resonant), elements(plate(v1::SolidModel::fem), resonant);
  const auto tip = ours.tip(4000), reference = elements.tip(4000);
  EXPECT_EQ(ours.value("model"), 1);
  RecordProperty("tip", fmt::format("{:.4g} {:.4g}", largest(reference), difference(tip, reference)));
  EXPECT_LT(difference(tip, reference), 0.03);
}

TEST(AutomaticModel, SaysInEveryAttemptAtAWindowThatElementsCompute) {
  const Pressure strong = [](double t, double) { return 400 * pulse(t, 0, 0.08); };
  LoadedPlate ours(plate(v1::SolidModel::auto_), strong);
  while (ours.notes.empty()) {
    const std::string start = ours.solid.solid.save();
    ours.advance();
    if (ours.notes.empty()) continue;
    // A scheme that iterates shows the notes of the last attempt alone.
    ours.solid.solid.restore(start);
    const Report again =
        ours.solid.solid.advance({.index = ours.solid.windows, .start = ours.solid.time - h, .size = h},
                                 ours.solid.load, ours.solid.motion);
    EXPECT_EQ(again.notes, ours.notes);
  }
}

TEST(AutomaticModel, ABodyThatNothingHoldsIsComputedByElements) {
  const auto falling = [](v1::SolidModel::Word model) {
    v1::Case c = test::plate({.clamped = false, .gravity = {0, -9.81}});
    c.mutable_solid()->set_model(model);
    LoadedSolid run(c, {});
    Report report;
    for (int k = 0; k < 20; ++k) report = run.advance(h);
    return run.value(report, "tip_y");
  };
  EXPECT_EQ(falling(v1::SolidModel::auto_), falling(v1::SolidModel::fem));
}

TEST(AutomaticModel, ContinuesFromASavedStateToTheBit) {
  const Pressure twice = [](double t, double) { return 100 * pulse(t, 0, 0.08) + 2 * pulse(t, 0.5, 0.05); };
  LoadedPlate first(plate(v1::SolidModel::auto_, 0.2), twice);
  std::vector<std::string> states;
  std::vector<double> tip;
  for (int k = 0; k < 3000; ++k) {
    if (k % 250 == 0) states.push_back(first.solid.solid.save());
    tip.push_back(first.advance());
  }
  double sum = 0;
  for (std::size_t s = 0; s < states.size(); ++s) {
    LoadedPlate second(plate(v1::SolidModel::auto_, 0.2), twice);
    second.solid.solid.restore(states[s]);
    second.solid.windows = 250 * s;
    for (std::size_t k = 0; k < 250 * s; ++k) second.solid.time += h;
    for (std::size_t k = 250 * s; k < std::min<std::size_t>(250 * s + 400, tip.size()); ++k)
      ASSERT_EQ(second.advance(), tip[k]) << s << " " << k;
    sum += second.value("model");
  }
  EXPECT_GT(sum, 0);  // both models are among the states
  EXPECT_LT(sum, static_cast<double>(states.size()));
}

TEST(AutomaticModel, TheWorkOfTheWaterIsThatOfTheStructure) {
  const Pressure twice = [](double t, double) { return 100 * pulse(t, 0, 0.08); };
  LoadedPlate ours(plate(v1::SolidModel::auto_), twice);
  double most = 0, left = 0;
  for (int k = 0; k < 600; ++k) {
    ours.advance();
    const double energy =
        ours.value("kinetic_energy") + ours.value("elastic_energy") + ours.value("gravity_energy");
    most = std::max(most, energy);
    left = std::max(left, std::abs(energy - ours.value("interface_work")));
  }
  RecordProperty("left", fmt::format("{:.3g}", left / most));
  EXPECT_LT(left, 0.01 * most);
}

}  // namespace
}  // namespace cosurge
