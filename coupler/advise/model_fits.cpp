#include <algorithm>
#include <cmath>
#include <limits>

#include "common/case/bodies.hpp"
#include "common/error.hpp"
#include "common/geometry/body_sites.hpp"
#include "coupler/advise/fit.hpp"

namespace cosurge {
namespace {

constexpr double felt = 0.01;        // deflection over a spacing from which on the water feels it
constexpr double small = 0.05;       // deflection over the longest side (docs/method_solid.md, section 6)
constexpr double across = 4;         // points across a body
constexpr double water_layers = 10;  // layers of water
constexpr double rounding = 1e-6;
constexpr double step_fraction = 0.7;  // step of explicit particles, over the stable one

const char* no_modulus = "needs solid.young_modulus";
const char* no_deflection =
    "the static deflection is not known: no plate, beam or layer that water of the start can load";

/// Largest deflection of all bodies relative to a length; nothing where one is not known.
std::optional<double> relative(const SceneNumbers& scene, const std::optional<double>& length) {
  double most = 0;
  for (const BodyNumbers& body : scene.bodies) {
    if (!body.deflection) return {};
    most = std::max(most, *body.deflection / length.value_or(body.longest));
  }
  return most;
}

Fit rigid(const v1::Case& the_case, const SceneNumbers& scene) {
  Fit fit{.name = "rigid"};
  const auto moved = relative(scene, the_case.fluid().spacing());
  if (!the_case.solid().has_young_modulus()) {
    fit.fits = the_case.solid().model() == v1::SolidModel::rigid;
    fit.why = fit.fits ? "the case has no modulus" : "the bodies would be fixed";
  } else if (!moved) {
    fit.why = no_deflection;
  } else {
    const double period = 1 / scene.wet_frequency.value_or(scene.dry_frequency);
    fit.fits = *moved < felt && period < scene.response;
    fit.why = fmt::format(
        "static deflection {:.4g} % of a spacing, limit {:g} %; period {:.3g} s, limit {:.3g} s, the "
        "response time of the water",
        100 * *moved, 100 * felt, period, scene.response);
  }
  return fit;
}

Fit modal(const v1::Case& the_case, const SceneNumbers& scene) {
  Fit fit{.name = "modal"};
  const auto moved = relative(scene, {});
  if (!the_case.solid().has_young_modulus()) {
    fit.why = no_modulus;
  } else if (!moved) {
    fit.why = no_deflection;
  } else {
    fit.fits = *moved < small;
    fit.why =
        fmt::format("static deflection {:.3g} % of the longest side, limit {:g} % (docs/method_solid.md)",
                    100 * *moved, 100 * small);
  }
  return fit;
}

Fit fem(const v1::Case& the_case) {
  if (!the_case.solid().has_young_modulus()) return {.name = "fem", .why = no_modulus};
  return {.name = "fem", .fits = true, .why = "any deflection, no limit on the sub-step (docs/stability.md)"};
}

Fit automatic(const v1::Case& the_case) {
  if (!the_case.solid().has_young_modulus()) return {.name = "auto", .why = no_modulus};
  return {
      .name = "auto",
      .fits = true,
      .why = "modal while it measures that the deflection is small and its modes are enough, fem otherwise"};
}

/// Explicit particles: sub-steps of about 0.7 l0 / c_p, as sound may cross a spacing in one.
Fit particles(const v1::Case& the_case, const SceneNumbers& scene, const std::string& name) {
  const v1::Solid& solid = the_case.solid();
  if (!solid.has_young_modulus()) return {.name = name, .why = no_modulus};
  const double spacing = solid_spacing(the_case);
  double layers = std::numeric_limits<double>::max();
  for (const BodyNumbers& body : scene.bodies) layers = std::min(layers, body.thickness / spacing);
  const double steps =
      scene.window * std::sqrt(solid.young_modulus() / solid.density()) / (step_fraction * spacing);
  return {
      .name = name,
      .fits = layers > across - rounding,
      .why = fmt::format("{:.3g} particles across the thinnest body, limit {:g}; about {:.0f} sub-steps a "
                         "window",
                         layers, across, std::max(1.0, std::ceil(steps)))};
}

Fit sprung(const v1::Solid& solid) {
  const bool chosen = solid.model() == v1::SolidModel::sprung;
  return {.name = "sprung",
          .fits = chosen,
          .why = chosen ? "rigid bodies move on the springs of the case"
                        : "for rigid bodies on springs, which the case does not choose"};
}

}  // namespace

std::vector<Fit> model_fits(const v1::Case& the_case, const SceneNumbers& scene) {
  return {sprung(the_case.solid()),
          rigid(the_case, scene),
          automatic(the_case),
          modal(the_case, scene),
          fem(the_case),
          particles(the_case, scene, "mps"),
          particles(the_case, scene, "hamiltonian")};
}

std::vector<std::string> coarse_spacings(const v1::Case& the_case, const SceneNumbers& scene) {
  const double spacing = the_case.fluid().spacing();
  std::vector<std::string> warnings;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (const double thickness = scene.bodies[b].thickness; thickness / spacing < across - rounding)
      warnings.push_back(fmt::format(
          "solid.body.{} is {:.3g} spacings thick, fewer than {:g}; use fluid.spacing of {:.3g} m or "
          "less",
          b, thickness / spacing, across, thickness / across));
  if (scene.layers < water_layers - rounding)
    warnings.push_back(
        fmt::format("the water is {:.3g} layers high, fewer than {:g}; use fluid.spacing of {:.3g} m or less",
                    scene.layers, water_layers, scene.head / water_layers));
  return warnings;
}

}  // namespace cosurge
