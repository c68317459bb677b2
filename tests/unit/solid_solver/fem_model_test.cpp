#include "solid_solver/models/fem/fem_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/loaded_solid.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::fem {
namespace {

using test::l0;
using test::LoadedSolid;

v1::Case elements(const test::SolidParameters& parameters, double rho_infinity) {
  v1::Case c = test::plate(parameters);
  c.mutable_solid()->set_model(v1::SolidModel::fem);
  c.mutable_solid()->mutable_fem()->set_rho_infinity(rho_infinity);
  return c;
}

/// Deflection and shortening of the middle of the end face of a plate of 2 x 100 mm, over its length, under
/// dead loads p EI / L^2 [N] on the given points in all.
Vec<2> deflection(const Field& points, double p) {
  constexpr int rows = 100, ramp = 20, rest = 3;
  v1::Case c = elements({.columns = 2, .rows = rows}, 0);
  c.mutable_solid()->mutable_fem()->set_element(0.005);  // one through the thickness
  c.mutable_coupling()->set_load(v1::Coupling::ramped);
  c.mutable_output()->mutable_probe(0)->set_position(0, l0);
  const Eigen::Index count = points.cols();
  LoadedSolid run(c, {.dimension = 2,
                      .position = points,
                      .area = Field::Zero(2, count),
                      .body = std::vector<int>(static_cast<std::size_t>(count), 0)});
  const double length = rows * l0, rigidity = 1e6 * std::pow(2 * l0, 3) / 12;
  Report report;
  // Windows of 200 periods and all oscillations damped: a series of balances.
  for (int k = 1; k <= ramp + rest; ++k) {
    const double force = std::min(1.0, static_cast<double>(k) / ramp) * p * rigidity / (length * length);
    run.load.force = Field::Zero(2, count);
    run.load.force.row(0).setConstant(force / static_cast<double>(count));
    report = run.advance(300);
  }
  return Vec<2>(run.value(report, "tip_x"), -run.value(report, "tip_y")) / length;
}

TEST(FemModel, BendsUnderATipLoadAsTheElasticaDoes) {
  const Field tip = Vec<2>(l0, 100 * l0);
  // P L^2 / EI, w / L, u / L: the exact elastica (Bisshopp & Drucker 1945; Mattiasson 1981).
  const std::vector<std::array<double, 3>> exact = {
      {1, .30172, .05643}, {4, .66996, .32894}, {10, .81061, .55500}};
  for (const auto& [load, w, u] : exact) {
    const Vec<2> tip_over_length = deflection(tip, load);
    RecordProperty(fmt::format("w_{}", load), fmt::format("{:.5f}", tip_over_length[0]));
    // Length over thickness 50: shear adds 0.6 / 50^2, and 20 elements of 1 x 2.5 are off by up to 2e-3
    // (measured).
    EXPECT_NEAR(tip_over_length[0] / w, 1, 0.005) << load;
    EXPECT_NEAR(tip_over_length[1] / u, 1, 0.005) << load;
  }
}

TEST(FemModel, BendsUnderAUniformDeadLoadAsTheElasticaDoes) {
  Field axis(2, 100);
  for (int j = 0; j < 100; ++j) axis.col(j) << l0, (j + 0.5) * l0;
  const std::vector<std::array<double, 3>> exact = {
      {1, .12347, .00875}, {4, .42516, .10989}, {10, .70020, .34365}};
  for (const auto& [load, w, u] : exact) {
    const Vec<2> tip_over_length = deflection(axis, load);
    RecordProperty(fmt::format("w_{}", load), fmt::format("{:.5f}", tip_over_length[0]));
    EXPECT_NEAR(tip_over_length[0] / w, 1, 0.005) << load;
    EXPECT_NEAR(tip_over_length[1] / u, 1, 0.005) << load;
  }
}

/// Motion of the plate of Amaro & Cheng, released under a lateral gravity.
struct Swing {
  double frequency;              // [Hz]
  double amplitude;              // amplitude of the tip [m]
  double lowest, highest, last;  // kinetic + elastic + gravity's energy over the largest kinetic energy
  double iterations;             // Newton iterations, mean over the windows
};

Swing swing(double gravity, double rho_infinity, double window, double duration) {
  LoadedSolid run(elements({.gravity = {gravity, 0}}, rho_infinity), {});
  std::vector<double> tip, energy;
  double kinetic = 0, iterations = 0;
  for (int k = 0; k * window < duration; ++k) {
    const Report report = run.advance(window);
    tip.push_back(run.value(report, "tip_x"));
    iterations += run.value(report, "newton_iterations");
    kinetic = std::max(kinetic, run.value(report, "kinetic_energy"));
    energy.push_back(run.value(report, "kinetic_energy") + run.value(report, "elastic_energy") +
                     run.value(report, "gravity_energy"));
  }
  const auto [low, high] = std::minmax_element(tip.begin(), tip.end());
  std::vector<double> rises;  // through the mean
  for (std::size_t k = 1; k < tip.size(); ++k) {
    const double a = tip[k - 1] - (*low + *high) / 2, b = tip[k] - (*low + *high) / 2;
    if (a < 0 && b >= 0) rises.push_back((static_cast<double>(k) - b / (b - a)) * window);
  }
  return {.frequency = static_cast<double>(rises.size() - 1) / (rises.back() - rises.front()),
          .amplitude = (*high - *low) / 2,
          .lowest = *std::min_element(energy.begin(), energy.end()) / kinetic,
          .highest = *std::max_element(energy.begin(), energy.end()) / kinetic,
          .last = energy.back() / kinetic,
          .iterations = iterations / static_cast<double>(tip.size())};
}

TEST(FemModel, SwingsAtTheFrequencyOfATimoshenkoBeam) {
  const Swing small = swing(0.01, 0.8, 1e-3, 1.1);
  RecordProperty("frequency", fmt::format("{:.4f}", small.frequency));
  // The elements are 2.4e-4 stiff, and the higher modes that the start excites move the rises by 1e-3.
  EXPECT_NEAR(small.frequency / 5.970, 1, 0.005);
}

TEST(FemModel, WithoutDampingItsEnergyStays) {
  const Swing wide = swing(25, 1, 5e-4, 1);
  RecordProperty("amplitude", fmt::format("{:.4f}", wide.amplitude));
  RecordProperty("energy", fmt::format("{:.2e} {:.2e}", wide.lowest, wide.highest));
  RecordProperty("iterations", fmt::format("{:.2f}", wide.iterations));
  EXPECT_GT(wide.amplitude, 0.02);  // a quarter of the length
  // The mid-point rule is symplectic: a ripple, no trend.
  EXPECT_LT(wide.highest - wide.lowest, 1e-4);
}

TEST(FemModel, DampingTakesShortOscillationsAndLeavesTheFirst) {
  const Swing damped = swing(1, 0.8, 1e-3, 1);
  // 168 windows a period: the method takes 1e-4 of this mode's energy in a second.
  EXPECT_LT(damped.last, 0);
  EXPECT_GT(damped.last, -1e-3);
  EXPECT_LE(damped.highest, 0);
}

TEST(FemModel, StepsOfAStiffBodyMayBeLongAgainstItsPeriods) {
  // Steel: a period of 0.6 ms, windows of 1 ms. Damped, it comes to rest at the static deflection.
  v1::Case c = elements({.young_modulus = 2e11, .poisson_ratio = 0.3, .density = 7800}, 0.5);
  Interface face = test::left_face(80);
  LoadedSolid run(c, face);
  Report report;
  for (int k = 0; k < 60; ++k) {
    run.load.force = Field::Zero(2, 80);
    run.load.force.row(0).setConstant(1000 * l0);  // 1 kPa
    report = run.advance(1e-3);
  }
  const double rigidity = 2e11 / (1 - 0.09) * std::pow(0.012, 3) / 12;
  const double beam = 1000 * std::pow(0.08, 4) / (8 * rigidity);
  const double shear = 1000 * 0.08 * 0.08 / (2 * 5.0 / 6 * 2e11 / 2.6 * 0.012);
  // Timoshenko's beam is 0.33 % slow against two dimensions with a clamp that lets nothing contract (see the
  // modes): 0.7 % in deflection.
  EXPECT_NEAR(run.value(report, "tip_x") / (beam + shear), 1, 0.015);
  EXPECT_LT(run.value(report, "max_speed"), 1e-9);
}

TEST(FemModel, SubStepsAreNoLongerThanAsked) {
  v1::Case c = elements({.rows = 20}, 0.8);
  EXPECT_EQ(LoadedSolid(c, {}).setup.substep, 0);
  EXPECT_EQ(LoadedSolid(c, {}).value(LoadedSolid(c, {}).advance(1e-3), "substeps"), 1);
  c.mutable_solid()->mutable_fem()->set_substep(1e-4);
  EXPECT_EQ(LoadedSolid(c, {}).value(LoadedSolid(c, {}).advance(1e-3), "substeps"), 10);
  EXPECT_EQ(LoadedSolid(c, {}).value(LoadedSolid(c, {}).advance(1.01e-3), "substeps"), 11);
}

/// A free bar of 60 x 300 mm (x 60 mm in space) in elements of 30 mm.
template <int dim>
FemBody<dim> bar(const Vec<dim>& gravity) {
  v1::Body body;
  std::vector<double> low(dim, 0.3), high(dim, 0.36);
  high[0] = 0.6;
  test::set_box(*body.mutable_box(), low, high);
  return {test::body_of<dim>(body),
          0,
          0.03,
          {.density = 2700, .young_modulus = 5e7, .poisson_ratio = 0.3},
          gravity};
}

template <int dim>
void fall() {
  const Vec<dim> g = -9.81 * Vec<dim>::Unit(1);
  const FemBody<dim> body = bar<dim>(g);
  GeneralisedAlpha<dim> motion(body, 0.3, 0);
  const Vector still = Vector::Zero(body.unknowns());
  motion.start(still);
  constexpr int steps = dim == 2 ? 4000 : 400;
  constexpr double dt = 1e-3;
  int iterations = 0;
  for (int k = 0; k < steps; ++k) {
    const NewtonReport report = motion.step(still, dt);
    ASSERT_TRUE(report.converged) << "step " << k << " residual " << report.residual;
    iterations += report.iterations;
  }
  EXPECT_LE(iterations, steps + 10);  // one each: rounding is not taken for a residual
  const double t = steps * dt;
  const Field u = body.to_nodes(motion.displacement());
  const Vec<dim> path = 0.5 * g * t * t;
  // Rounding of the steps in the path; of 80 m in the strain.
  EXPECT_LT((u.colwise() - path).cwiseAbs().maxCoeff(), 1e-9 * path.norm());
  EXPECT_LT(body.deformation(motion.displacement()).strain, 1e-11);
}

TEST(FemModel, AFreeBodyFallsAsLongAsItLikesWithoutStrain) {
  fall<2>();
  fall<3>();
}

/// A free bar that turns and flies under gravity, in the plane by 30 rad and 20 m.
template <int dim>
void tumble(double omega, int steps) {
  const FemBody<dim> body = bar<dim>(-9.81 * Vec<dim>::Unit(1));
  GeneralisedAlpha<dim> motion(body, 1, 0);
  Field v = Field::Zero(dim, body.mesh().nodes());
  const Vec<dim> centre = body.mesh().position().rowwise().mean();
  for (Eigen::Index n = 0; n < v.cols(); ++n) {
    const Vec<dim> arm = body.mesh().position().col(n) - centre;
    v(0, n) = 5 - omega * arm[1];
    v(1, n) = omega * arm[0];
    if (dim == 3) v(2, n) = 1;
  }
  motion.place(Vector::Zero(body.unknowns()), body.from_nodes(v));
  const Vector still = Vector::Zero(body.unknowns());
  motion.start(still);
  const auto energy = [&] {
    const Vector &u = motion.displacement(), &w = motion.velocity();
    return 0.5 * w.dot(body.momentum(w)) + body.elastic_energy(u) - body.weight().dot(u);
  };
  const double before = energy();
  double kinetic = 0;
  for (int k = 0; k < steps; ++k) {
    const NewtonReport report = motion.step(still, 1e-3);
    ASSERT_TRUE(report.converged) << "step " << k << " residual " << report.residual;
    kinetic = std::max(kinetic, 0.5 * motion.velocity().dot(body.momentum(motion.velocity())));
  }
  // The mid-point rule conserves linear momentum to rounding, and energy except for nonlinear terms.
  const Field w = body.to_nodes(motion.velocity());
  const Vector unit = body.from_nodes(Field(Field::Ones(dim, w.cols())));
  const double mass = unit.dot(body.momentum(unit)) / dim;
  Field along = Field::Zero(dim, w.cols());
  along.row(1).setOnes();
  EXPECT_NEAR(body.from_nodes(along).dot(body.momentum(motion.velocity())) / mass, -9.81e-3 * steps, 1e-8);
  EXPECT_LT(std::abs(energy() - before) / kinetic, 1e-3);
}

TEST(FemModel, AFreeBodyTumblesThroughTheAir) {
  tumble<2>(15, 2000);
  tumble<3>(15, 60);
}

TEST(FemModel, ABodyAtRestAfterABlowFindsItsBalance) {
  // A free bar is hit for a millisecond, rings, loses its oscillations to rho_infinity, and moves on.
  const FemBody<2> body = bar<2>(Vec<2>::Zero());
  GeneralisedAlpha<2> motion(body, 0, 0);
  const Vector still = Vector::Zero(body.unknowns());
  Field blow = Field::Zero(2, body.mesh().nodes());
  blow(1, 0) = 1e4;
  motion.start(still);
  for (int k = 0; k < 3000; ++k) {
    const NewtonReport report = motion.step(k < 1 ? body.from_nodes(blow) : still, 1e-3);
    ASSERT_TRUE(report.converged) << "step " << k << " residual " << report.residual;
  }
}

/// The plate of a dam break, far too soft for its own weight.
v1::Case slack(v1::Solid::Material material) {
  v1::Case c = elements({.columns = 16, .young_modulus = 1e4, .gravity = {0, -9.81}}, 0.3);
  c.mutable_solid()->set_material(material);
  return c;
}

TEST(FemModel, AMaterialThatCollapsesIsNamedWithOneThatDoesNot) {
  LoadedSolid stands(slack(v1::Solid::neo_hookean), {}), falls(slack(v1::Solid::st_venant_kirchhoff), {});
  for (int k = 0; k < 1000; ++k) stands.advance(1e-3);
  try {
    for (int k = 0; k < 1000; ++k) falls.advance(1e-3);
    FAIL() << "stands";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("the material collapses in body 0, near (0."), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("neo_hookean"), std::string::npos) << error.what();
  }
}

TEST(FemModel, LoadsBeyondAnyBalanceSayWhatToDo) {
  LoadedSolid run(elements({.rows = 20}, 0.8), test::left_face(20));
  run.advance(1e-4);
  run.load.force.setConstant(1e6);
  try {
    run.advance(1e-2);
    FAIL() << "went on";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("t = 0.0001 s"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("coupling.load"), std::string::npos) << error.what();
  }
}

TEST(FemModel, PointsFarFromTheBodyAreRefused) {
  Interface points = test::left_face(20);
  points.position.row(0).array() -= l0;  // half a spacing outside
  EXPECT_NO_THROW(LoadedSolid(elements({.rows = 20}, 0.8), points));
  points.position.row(0).array() -= 0.1 * l0;
  EXPECT_THROW(LoadedSolid(elements({.rows = 20}, 0.8), points), Error);
  points.position.row(1).array() -= 0.02;  // beside the clamp
  EXPECT_THROW(LoadedSolid(elements({.rows = 20}, 0.8), points), Error);
  points.position.row(0).array() += 1.1 * l0;  // in it
  EXPECT_NO_THROW(LoadedSolid(elements({.rows = 20}, 0.8), points));
}

}  // namespace
}  // namespace cosurge::fem
