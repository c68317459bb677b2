#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/case/case_file.hpp"
#include "coupler/advise/fit.hpp"
#include "coupler/advise/static_deflection.hpp"

namespace cosurge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

v1::Case scene_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return load_case(COSURGE_SOURCE_DIR "/cases/" + name, overrides);
}

/// With the settings of the tables in docs/stability.md.
v1::Case plate(double modulus, std::vector<std::string> overrides = {}) {
  for (const char* word : {"time.window=1e-4", "fluid.propagation_speed=1", "coupling.scheme=weak"})
    overrides.emplace_back(word);
  overrides.push_back(fmt::format("solid.young_modulus={}", modulus));
  return scene_of("dam_break_plate", overrides);
}

/// First bending of the plate of 12 x 80 mm in vacuum, Euler and Bernoulli [Hz].
double bending(double modulus) {
  const double stiffness = modulus * std::pow(0.012, 3) / 12, mass = 2500 * 0.012;
  return std::pow(1.8751 / 0.08, 2) * std::sqrt(stiffness / mass) / (2 * std::numbers::pi);
}

SceneNumbers plate_numbers(double modulus) { return scene_numbers(plate(modulus), bending(modulus)); }

/// The verdict on one word.
Fit of(const std::vector<Fit>& fits, const std::string& name) {
  for (const Fit& fit : fits)
    if (fit.name == name) return fit;
  ADD_FAILURE() << "no line for " << name;
  return {};
}

/// Names of what fits.
std::vector<std::string> fitting(const std::vector<Fit>& fits) {
  std::vector<std::string> names;
  for (const Fit& fit : fits)
    if (fit.fits) names.push_back(fit.name);
  return names;
}

TEST(SceneNumbers, OfThePublishedPlate) {
  const SceneNumbers scene = plate_numbers(1e6);
  EXPECT_DOUBLE_EQ(scene.head, 0.292);
  EXPECT_NEAR(scene.layers, 146, 1e-9);
  EXPECT_NEAR(scene.speed, 2.3935, 1e-4);
  EXPECT_NEAR(scene.cauchy.value(), 1000 * 2 * 9.81 * 0.292 / 1e6, 1e-12);
  EXPECT_NEAR(scene.reynolds.value(), 2.3935 * 0.292 / 1e-6, 100);
  EXPECT_NEAR(scene.courant, 2.3935 * 1e-4 / 0.002, 1e-5);
  ASSERT_EQ(scene.bodies.size(), 1U);
  const BodyNumbers& body = scene.bodies.front();
  EXPECT_NEAR(body.mass, 2500 * 0.012 * 0.08, 1e-9);
  EXPECT_NEAR(body.displaced, 1000 * 0.012 * 0.08, 1e-9);
  EXPECT_NEAR(body.added_mass_ratio.value(), 1000 * 0.04 / (2500 * 0.012), 1e-9);
  // rho c L / (rho_s c_p l0) of docs/stability.md with L = 0.04 m, c = 1 m/s, c_p = 20 m/s.
  EXPECT_NEAR(body.gain.value(), 1000 * 1 * 0.04 / (2500 * 20 * 0.002), 1e-9);
  EXPECT_NEAR(scene.wet_frequency.value(), bending(1e6) / std::sqrt(1 + 4.0 / 3), 1e-9);
}

TEST(SceneNumbers, DeflectionOfThePlateIsThatOfBeamTheory) {
  // A uniform load q L^4 / (8 E I) and a triangle of q L^4 / (30 E I) with its largest value at the clamp.
  const double length = 0.08, stiffness = 1e6 * std::pow(0.012, 3) / 12, weight = 1000 * 9.81;
  const double theory = weight * (0.292 - length) * std::pow(length, 4) / (8 * stiffness) +
                        weight * length * std::pow(length, 4) / (30 * stiffness);
  EXPECT_NEAR(static_deflection(plate(1e6), 0).value() / theory, 1, 1e-5);
  EXPECT_NEAR(static_deflection(plate(2e9), 0).value() / theory, 1e6 / 2e9, 1e-8);
  EXPECT_NEAR(static_deflection(plate(1e6, {"solid.poisson_ratio=0.3"}), 0).value() / theory, 1 - 0.09, 1e-5);
  EXPECT_NEAR(
      static_deflection(plate(1e6, {"solid.poisson_ratio=0.3", "solid.plane=plane_stress"}), 0).value() /
          theory,
      1, 1e-5);
}

TEST(SceneNumbers, APlateClampedAtBothEndsBendsAsTheory) {
  // Under the water of 0.292 m from 0 to 0.08 m the middle sees the mean pressure: q L^4 / (384 E I).
  v1::Case both = plate(1e6);
  v1::Shape* upper = both.mutable_solid()->mutable_body(0)->add_clamp();
  for (const double x : {0.292, 0.08}) upper->add_min(x);
  for (const double x : {0.304, 0.1}) upper->add_max(x);
  const double stiffness = 1e6 * std::pow(0.012, 3) / 12;
  EXPECT_NEAR(static_deflection(both, 0).value() / (9810 * 0.252 * std::pow(0.08, 4) / (384 * stiffness)), 1,
              1e-5);
  // Nothing is known of a plate that no clamp holds.
  both.mutable_solid()->mutable_body(0)->clear_clamp();
  EXPECT_EQ(static_deflection(both, 0), std::nullopt);
}

TEST(SceneNumbers, OfAPlateInSpace) {
  // 24 x 56 x 80 mm: narrower than long, so that it bends with E. The water is 0.288 m high.
  const SceneNumbers scene =
      scene_numbers(scene_of("dam_break_plate_3d", {"solid.poisson_ratio=0.3"}), 11.47);
  const BodyNumbers& body = scene.bodies.front();
  EXPECT_NEAR(body.mass, 2500 * 0.024 * 0.056 * 0.08, 1e-9);
  EXPECT_NEAR(body.added_mass_ratio.value(), 1000 * 0.04 / (2500 * 0.024), 1e-9);
  const double stiffness = 1e6 * std::pow(0.024, 3) / 12;
  const double theory =
      9810 * std::pow(0.08, 4) * ((0.288 - 0.08) / (8 * stiffness) + 0.08 / (30 * stiffness));
  EXPECT_NEAR(body.deflection.value() / theory, 1, 1e-5);
}

TEST(SceneNumbers, OfThePiston) {
  // sqrt(k / m) without water and 2 Hz with it, by the case's comments.
  const SceneNumbers scene =
      scene_numbers(scene_of("sprung_piston"), std::sqrt(9474.8 / 40) / (2 * std::numbers::pi));
  EXPECT_NEAR(scene.bodies.front().mass, 40, 1e-9);
  EXPECT_NEAR(scene.bodies.front().added_mass_ratio.value(), 0.5, 1e-9);
  EXPECT_NEAR(scene.wet_frequency.value(), 2, 1e-3);
  EXPECT_EQ(scene.cauchy, std::nullopt);
  EXPECT_EQ(scene.bodies.front().deflection, std::nullopt);
}

TEST(SceneNumbers, OfTheSoftFloor) {
  const SceneNumbers scene = scene_numbers(scene_of("soft_floor"), 159.9);
  const BodyNumbers& body = scene.bodies.front();
  EXPECT_NEAR(body.added_mass_ratio.value(), 4, 1e-9);
  EXPECT_NEAR(body.deflection.value(), 1000 * 9.81 * 0.2 * 0.02 / 1e6, 1e-12);
  // The rod with the water on top: x tan x = 1/4 at x = 0.48009.
  EXPECT_NEAR(scene.wet_frequency.value(), 0.48009 * 20 / (2 * std::numbers::pi * 0.02), 0.01);
  // The simulated floor swings at 82.3 Hz (verification_scenes, SoftFloor).
  EXPECT_NEAR(scene.wet_frequency.value() / 82.3, 1, 0.08);
}

TEST(Fits, ModelsOfPlatesFollowTheirDeflection) {
  EXPECT_THAT(fitting(model_fits(plate(1e6), plate_numbers(1e6))),
              ::testing::ElementsAre("auto", "fem", "mps", "hamiltonian"));
  EXPECT_THAT(fitting(model_fits(plate(2e9), plate_numbers(2e9))),
              ::testing::ElementsAre("auto", "modal", "fem", "mps", "hamiltonian"));
  EXPECT_TRUE(of(model_fits(plate(2e11), plate_numbers(2e11)), "rigid").fits);
  EXPECT_THAT(of(model_fits(plate(1e6), plate_numbers(1e6)), "modal").why,
              HasSubstr("102 % of the longest side"));
}

TEST(Fits, AFloorThatSwingsSlowlyIsNotRigidHoweverLittleItMoves) {
  const v1::Case floor = scene_of("soft_floor");
  const SceneNumbers scene = scene_numbers(floor, 159.9);
  EXPECT_FALSE(of(model_fits(floor, scene), "rigid").fits);
  EXPECT_TRUE(of(model_fits(floor, scene), "modal").fits);
}

TEST(Fits, WeakUpToTheLimitsOfTheStabilityTable) {
  v1::Coupling coupling;
  EXPECT_EQ(weak_limit(coupling), 2);
  coupling.set_load(v1::Coupling::ramped);
  EXPECT_EQ(weak_limit(coupling), 1.5);
  coupling.set_velocity(v1::Coupling::end);
  EXPECT_EQ(weak_limit(coupling), 2);
  coupling.set_load(v1::Coupling::held);
  EXPECT_EQ(weak_limit(coupling), 1);
  coupling.set_prediction(v1::Coupling::extrapolated);
  EXPECT_EQ(weak_limit(coupling), 1.0 / 3);
  const v1::Case floor = scene_of("soft_floor"), piston = scene_of("sprung_piston");
  EXPECT_FALSE(of(scheme_fits(floor, scene_numbers(floor, 159.9)), "weak").fits);
  EXPECT_TRUE(of(scheme_fits(piston, scene_numbers(piston, 2.449)), "weak").fits);
  const v1::Case late = scene_of("soft_floor", {"coupling.load=ramped"});  // mean and ramped: up to 3
  EXPECT_FALSE(of(scheme_fits(late, scene_numbers(late, 159.9)), "strong").fits);
}

TEST(Fits, SourcesThatMakeASoftPlateUnstableAreTold) {
  // As docs/stability.md measured: with mixed only iterated schemes, with deviation no scheme.
  for (const auto& [source, schemes] :
       {std::pair{"mixed", std::vector<std::string>{"strong", "strong_inertial", "auto"}},
        {"deviation", std::vector<std::string>{}}}) {
    const v1::Case soft = plate(1e6, {fmt::format("fluid.source={}", source)});
    const SceneNumbers scene = scene_numbers(soft, bending(1e6));
    EXPECT_EQ(fitting(scheme_fits(soft, scene)), schemes) << source;
    EXPECT_THAT(recommendation(soft, scene), HasSubstr("Use the source time_scale, the model auto"))
        << source;
  }
}

/// Schemes without and with iterations that fit the soft plate on a spacing.
std::pair<bool, bool> weak_and_strong(const std::string& spacing, std::vector<std::string> words) {
  words.push_back("fluid.spacing=" + spacing);
  const v1::Case soft = plate(1e6, words);
  const std::vector<Fit> fits = scheme_fits(soft, scene_numbers(soft, bending(1e6)));
  return {of(fits, "weak").fits, of(fits, "strong").fits};
}

TEST(Fits, WavesThroughTheThicknessFollowTheTableOfFinerLattices) {
  using Pair = std::pair<bool, bool>;
  const std::vector<std::string> elements = {"solid.fem.rho_infinity=0.8"};
  EXPECT_EQ(weak_and_strong("0.002", elements), Pair(true, true));
  EXPECT_EQ(weak_and_strong("0.001", elements), Pair(false, true));
  EXPECT_EQ(weak_and_strong("0.001", {}), Pair(true, true));  // the default damps them
  const std::vector<std::string> particles = {"solid.model=mps", "solid.mps.viscosity=0"};
  EXPECT_EQ(weak_and_strong("0.002", particles), Pair(false, true));
  EXPECT_EQ(weak_and_strong("0.001", particles), Pair(false, false));
  EXPECT_EQ(weak_and_strong("0.002", {"solid.model=mps"}), Pair(true, true));
}

TEST(Recommendation, NamesTheCheapestModelAndAStableScheme) {
  EXPECT_THAT(recommendation(plate(1e6), plate_numbers(1e6)), HasSubstr("model auto and the scheme auto"));
  EXPECT_THAT(recommendation(plate(2e9), plate_numbers(2e9)), HasSubstr("model auto and the scheme auto"));
  // Its displacement is asked for by a probe; without one, a plate of steel is rigid.
  v1::Case steel = plate(2e11);
  EXPECT_THAT(recommendation(steel, plate_numbers(2e11)), HasSubstr("model auto"));
  steel.mutable_output()->clear_probe();
  EXPECT_THAT(recommendation(steel, plate_numbers(2e11)), HasSubstr("model rigid and the scheme weak"));
  const v1::Case piston = scene_of("sprung_piston"), floor = scene_of("soft_floor");
  EXPECT_THAT(recommendation(piston, scene_numbers(piston, 2.449)),
              AllOf(HasSubstr("model sprung and the scheme weak"), HasSubstr("1.5")));
  EXPECT_THAT(recommendation(floor, scene_numbers(floor, 159.9)),
              HasSubstr("model auto and the scheme strong with coupling.velocity = \"end\""));
}

TEST(CoarseSpacings, AreWarnedOfWithOneThatIsFineEnough) {
  EXPECT_THAT(coarse_spacings(plate(1e6), plate_numbers(1e6)), IsEmpty());
  const v1::Case coarse = plate(1e6, {"fluid.spacing=0.004", "fluid.water.0.max=[0.144,0.036]"});
  EXPECT_THAT(
      coarse_spacings(coarse, scene_numbers(coarse, 5.97)),
      ::testing::ElementsAre(HasSubstr("solid.body.0 is 3 spacings thick, fewer than 4; use fluid.spacing "
                                       "of 0.003 m or less"),
                             HasSubstr("the water is 9 layers high, fewer than 10; use fluid.spacing of "
                                       "0.0036 m or less")));
}

}  // namespace
}  // namespace cosurge
