#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "solid_solver/models/fem/spectral_radius.hpp"
#include "solid_solver/models/modal/modal_model.hpp"
#include "tests/support/loaded_solid.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::modal {
namespace {

using test::l0;
using test::LoadedSolid;

/// Frequencies [Hz] of a plate's lowest modes.
Eigen::ArrayXd frequencies(const test::SolidParameters& p, double element, int count) {
  const v1::Case c = test::plate(p);
  const Elasticity material{
      .density = p.density, .young_modulus = p.young_modulus, .poisson_ratio = p.poisson_ratio};
  const fem::FemBody<2> body(test::body_of<2>(c.solid().body(0)), 0, element, material, Vec<2>::Zero());
  return lowest_modes(body, material, count).omega_squared.array().sqrt() / (2 * std::numbers::pi);
}

TEST(Modes, AreOrthogonalAndOfUnitMass) {
  const v1::Case c = test::plate({});
  const Elasticity material{.density = 2500, .young_modulus = 1e6, .poisson_ratio = 0.3};
  const fem::FemBody<2> body(test::body_of<2>(c.solid().body(0)), 0, 0, material, Vec<2>::Zero());
  const Modes modes = lowest_modes(body, material, 12);
  const fem::Matrix stiffness = body.tangent(fem::Vector::Zero(body.unknowns()));
  const double highest = modes.omega_squared[11];
  for (int i = 0; i < 12; ++i) {
    const fem::Vector shape = modes.shapes.col(i);
    const fem::Vector pull = stiffness.selfadjointView<Eigen::Lower>() * shape,
                      momentum = body.momentum(shape);
    for (int j = 0; j < 12; ++j) {
      // The iteration's tolerance is 1e-12.
      EXPECT_NEAR(modes.shapes.col(j).dot(momentum), i == j ? 1 : 0, 1e-10);
      EXPECT_NEAR(modes.shapes.col(j).dot(pull), i == j ? modes.omega_squared[i] : 0, 1e-9 * highest);
    }
  }
}

TEST(Modes, AFreeBodyHasThreeThatCostNothing) {
  const Eigen::ArrayXd f = frequencies({.columns = 12, .rows = 40, .clamped = false}, 0, 5);
  EXPECT_EQ(f[0], 0);
  EXPECT_EQ(f[1], 0);
  EXPECT_EQ(f[2], 0);
  EXPECT_GT(f[3], 10);
}

TEST(Modes, TheFirstIsThatOfATimoshenkoBeam) {
  const double f1 = frequencies({}, 0, 1)[0];
  RecordProperty("frequency", fmt::format("{:.4f}", f1));
  EXPECT_NEAR(f1 / 5.970, 1, 0.005);  // measured: 1.0002
}

TEST(Modes, AClampThatLetsNothingContractIsStifferThanABeamTheoryKnows) {
  // With Poisson's ratio 0.3 two dimensions tend to 15.831 Hz, 0.33 % above Timoshenko's beam in plane
  // strain, 15.78 Hz: the foot cannot contract sideways. Elements of 12, 6, 3, 1.5 and 0.75 mm.
  const test::SolidParameters plate{.young_modulus = 2e7, .poisson_ratio = 0.3, .density = 7800};
  double before = 0, step_before = 0;
  for (const double element : {0.012, 0.006, 0.003, 0.0015}) {
    const double f1 = frequencies(plate, element, 1)[0];
    RecordProperty(fmt::format("f1_{}", element), fmt::format("{:.4f}", f1));
    if (before > 0) {
      EXPECT_LT(f1, before);  // elements are too stiff, never too soft
    }
    // The corners of the foot are singular: each halving takes a third of what the last one did, not a
    // sixteenth.
    if (step_before > 0) {
      EXPECT_LT(before - f1, 0.5 * step_before);
    }
    step_before = before > 0 ? before - f1 : 0;
    before = f1;
  }
  EXPECT_NEAR(before / 15.831, 1, 0.0005);
  const double by_default = frequencies(plate, 0, 1)[0];
  RecordProperty("f1_default", fmt::format("{:.4f}", by_default));
  EXPECT_NEAR(by_default / 15.778, 1, 0.005);  // Timoshenko's beam; two elements across would be 0.52 % off
}

TEST(Modes, GraysCantileverHasItsPeriod) {
  // Gray, Monaghan & Swift (2001): 0.254 s of a thin plate; thickness over length 0.1 makes it 0.5 % longer.
  const double f1 = frequencies(
      {.columns = 20, .rows = 200, .young_modulus = 2e6, .poisson_ratio = 0.3975, .density = 1000}, 0, 1)[0];
  RecordProperty("period", fmt::format("{:.5f}", 1 / f1));
  EXPECT_NEAR(1 / f1 / 0.2540, 1, 0.01);
}

TEST(ModalModel, MovesAsTheElementsDoWhereDeflectionIsSmall) {
  // A pulse of 40 ms on the plate of Amaro & Cheng: the tip moves 0.16 mm.
  const auto tip = [](v1::SolidModel::Word model) {
    v1::Case c = test::plate({});
    c.mutable_solid()->set_model(model);
    c.mutable_solid()->mutable_fem()->set_rho_infinity(1);
    c.mutable_solid()->mutable_modal()->set_modes(12);
    c.mutable_coupling()->set_load(v1::Coupling::ramped);
    LoadedSolid run(c, test::left_face(80));
    std::vector<double> history;
    for (int k = 0; k < 400; ++k) {
      const double load = k < 80 ? std::pow(std::sin(std::numbers::pi * k / 80), 2) : 0;
      run.load.force = Field::Zero(2, 80);
      run.load.force.row(0).setConstant(6 * load * l0);
      history.push_back(run.value(run.advance(5e-4), "tip_x"));
    }
    return history;
  };
  const std::vector<double> elements = tip(v1::SolidModel::fem), modes = tip(v1::SolidModel::modal);
  const double peak = *std::max_element(elements.begin(), elements.end());
  RecordProperty("peak", fmt::format("{:.3e} {:.3e}", peak, *std::max_element(modes.begin(), modes.end())));
  for (std::size_t k = 0; k < elements.size(); ++k)
    EXPECT_NEAR(modes[k], elements[k], 0.01 * peak) << "window " << k;
}

TEST(AmplitudeFactor, IsThatOfAStepOfTheGeneralisedAlphaMethod) {
  // 400 steps of one unknown with unit mass, by the method itself; the last 200 have no start-up left.
  for (const double rho : {0.0, 0.3, 0.8, 1.0}) {
    const fem::AlphaConstants constants(rho);
    const auto& [alpha_m, alpha_f, beta, gamma] = constants;
    for (const double angle : {0.05, 0.3, 1.0, 3.0}) {
      double u = 1, v = 0, a = -angle * angle;  // in steps
      const auto size = [&] { return std::hypot(angle * u, v); };
      double largest_before = 0, largest_after = 0;
      for (int k = 0; k < 400; ++k) {
        const double known = u + v + (0.5 - beta) * a;
        const double next = -(alpha_m * a + angle * angle * ((1 - alpha_f) * known + alpha_f * u)) /
                            (1 - alpha_m + (1 - alpha_f) * angle * angle * beta);
        u = known + beta * next;
        v += (1 - gamma) * a + gamma * next;
        a = next;
        if (k < 200) largest_before = k >= 100 ? std::max(largest_before, size()) : 0;
        if (k >= 300) largest_after = std::max(largest_after, size());
      }
      if (largest_after == 0) continue;  // nothing is left
      EXPECT_NEAR(std::pow(largest_after / largest_before, 1.0 / 200),
                  fem::amplitude_factor(constants, angle), 1e-3)
          << rho << " " << angle;
    }
    EXPECT_NEAR(fem::amplitude_factor(constants, 1e5), rho, 1e-3 + 1e-4 * rho);
    EXPECT_NEAR(fem::amplitude_factor(constants, 1e-3), 1, 1e-9);
  }
}

TEST(ModalModel, OscillationsThatAWindowDoesNotResolveLoseAmplitudeAsInElements) {
  // A blow on the end of the plate; windows of a fifth of the first period, and of a fiftieth.
  const auto left = [](v1::SolidModel::Word model, double rho, int windows_per_period) {
    v1::Case c = test::plate({});
    c.mutable_solid()->set_model(model);
    c.mutable_solid()->mutable_modal()->set_modes(1);
    c.mutable_solid()->mutable_fem()->set_rho_infinity(rho);
    LoadedSolid run(c, test::left_face(80));
    const double h = 1 / (5.97 * windows_per_period);
    run.load.force = Field::Zero(2, 80);
    run.load.force.row(0).setConstant(0.01 * l0 / h);
    run.advance(h);
    run.load.force.setZero();
    std::vector<double> tip;
    for (int k = 0; k < 10 * windows_per_period; ++k)
      tip.push_back(std::abs(run.value(run.advance(h), "tip_x")));
    const auto period = static_cast<std::ptrdiff_t>(windows_per_period);
    return *std::max_element(tip.end() - period, tip.end()) /
           *std::max_element(tip.begin(), tip.begin() + period);
  };
  EXPECT_NEAR(left(v1::SolidModel::modal, 1, 5), 1, 0.05);  // five samples of a period
  EXPECT_NEAR(left(v1::SolidModel::modal, 0.3, 50), 1, 0.02);
  EXPECT_LT(left(v1::SolidModel::modal, 0.3, 5), 0.15);  // 0.75 in a period
  EXPECT_NEAR(left(v1::SolidModel::modal, 0.3, 5), left(v1::SolidModel::fem, 0.3, 5), 0.05);
}

TEST(ModalModel, SaysHowFarItIsFromSmallDeflection) {
  v1::Case c = test::plate({});
  c.mutable_solid()->set_model(v1::SolidModel::modal);
  LoadedSolid run(c, test::left_face(80));
  double rotation = 0, strain = 0, deflection = 0, tip = 0;
  for (int k = 0; k < 40; ++k) {
    run.load.force = Field::Zero(2, 80);
    run.load.force.row(0).setConstant(10 * l0);
    const Report report = run.advance(1e-3);
    rotation = run.value(report, "largest_rotation");
    strain = run.value(report, "largest_strain");
    deflection = run.value(report, "largest_deflection");
    tip = run.value(report, "tip_x");
  }
  ASSERT_GT(tip, 0);
  // The first mode of a cantilever has the slope 1.377 w / L at its tip and the curvature 3.516 w / L^2 at
  // its foot. The second mode bends the tip too, and the foot's corners have more strain than a beam.
  const double slope = 1.377 * tip / 0.08, bending = 3.516 * tip * 0.006 / (0.08 * 0.08);
  EXPECT_NEAR(deflection / (tip / 0.08), 1, 0.01);  // the corner's, which goes down, too
  EXPECT_NEAR(rotation / slope, 1, 0.15);
  EXPECT_GT(strain / bending, 1);
  EXPECT_LT(strain / bending, 1.5);
}

TEST(ModalModel, AFreeFallIsNoDeflection) {
  v1::Case c = test::plate({.clamped = false, .gravity = {0, -9.81}});
  c.mutable_solid()->set_model(v1::SolidModel::modal);
  LoadedSolid run(c, {});
  Report report;
  for (int k = 0; k < 100; ++k) report = run.advance(1e-3);
  EXPECT_LT(run.value(report, "tip_y"), -0.04);
  EXPECT_LT(run.value(report, "largest_deflection"), 1e-6);  // rounding of modes as a whole, 1e-6 of others
}

TEST(ModalModel, MoreModesThanUnknownsAreRefused) {
  v1::Case c = test::plate({.columns = 4, .rows = 4});
  c.mutable_solid()->set_model(v1::SolidModel::modal);
  c.mutable_solid()->mutable_fem()->set_element(0.004);  // one element, 6 nodes free
  c.mutable_solid()->mutable_modal()->set_modes(12);
  EXPECT_THROW(LoadedSolid(c, {}), Error);
  c.mutable_solid()->mutable_modal()->set_modes(11);
  EXPECT_NO_THROW(LoadedSolid(c, {}));
}

}  // namespace
}  // namespace cosurge::modal
