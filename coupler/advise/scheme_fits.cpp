#include <algorithm>

#include "common/error.hpp"
#include "coupler/advise/fit.hpp"

namespace cosurge {
namespace {

constexpr double late_limit = 3;  // mu of every scheme with `mean` and `ramped`
// Gain of waves through the thickness (docs/stability.md, finer lattices). With mu of scene_numbers() the
// plate there has 0.4 on 2 mm and 0.8 on 1 mm: elements without damping are stable on the first and unstable
// on the second; particles without viscosity are unstable on both, with iterations on the second.
constexpr double gain_limit = 0.5;
constexpr double gain_limit_of_particles = 0.25;
constexpr double damped = 0.3;   // rho_infinity up to which `fem` damps such waves
constexpr double viscous = 0.2;  // viscosity of particles from which on they do

bool late(const v1::Coupling& coupling) {
  return coupling.velocity() == v1::Coupling::mean && coupling.load() == v1::Coupling::ramped;
}

/// Whether the model has waves through its thickness that its time integration does not damp.
bool has_free_waves(const v1::Solid& solid) {
  switch (solid.model()) {
    case v1::SolidModel::fem:
    case v1::SolidModel::auto_:
      return solid.fem().rho_infinity() > damped;
    case v1::SolidModel::mps:
      return solid.mps().viscosity() < viscous;
    case v1::SolidModel::hamiltonian:
      return solid.hamiltonian().viscosity() < viscous;
    default:
      return false;
  }
}

bool is_of_particles(const v1::Solid& solid) {
  return solid.model() == v1::SolidModel::mps || solid.model() == v1::SolidModel::hamiltonian;
}

bool is_continuum(const v1::Solid& solid) {
  return solid.model() == v1::SolidModel::fem || solid.model() == v1::SolidModel::auto_ ||
         is_of_particles(solid);
}

/// Why waves through the thickness make a scheme unstable; empty if they do not. `iterates`: a scheme with
/// iterations, which fails only with the source deviation and with particles without viscosity.
std::string waves(const v1::Case& the_case, const SceneNumbers& scene, bool iterates) {
  const v1::Solid& solid = the_case.solid();
  const auto gain = scene.largest(&BodyNumbers::gain);
  const bool impulsive = the_case.fluid().source() != v1::Fluid::time_scale && is_continuum(solid);
  const bool particles = is_of_particles(solid) && has_free_waves(solid);
  const double limit = particles && !iterates ? gain_limit_of_particles : gain_limit;
  const bool open = iterates ? particles || (impulsive && the_case.fluid().source() == v1::Fluid::deviation)
                             : impulsive || has_free_waves(solid);
  if (!gain || *gain < limit || !open) return "";
  return fmt::format("gain {:.2g} of waves through the thickness, limit {:g}{}", *gain, limit,
                     impulsive ? " with this source" : " without damping");
}

std::string ratio_text(const std::optional<double>& mu) {
  return mu ? fmt::format("mu about {:.3g}", *mu) : "mu is not known";
}

Fit weak(const v1::Case& the_case, const SceneNumbers& scene) {
  Fit fit{.name = "weak"};
  const auto limit = weak_limit(the_case.coupling());
  const auto mu = scene.largest(&BodyNumbers::added_mass_ratio);
  if (the_case.solid().model() == v1::SolidModel::rigid)
    return {.name = "weak", .fits = true, .why = "rigid bodies do not respond to the load"};
  if (const std::string why = waves(the_case, scene, false); !why.empty())
    return {.name = "weak", .why = why};
  if (!limit) {
    fit.why = ratio_text(mu) + "; the limit of these settings is not known";
    return fit;
  }
  fit.fits = mu && *mu < *limit;
  fit.why = fmt::format("{}, limit {:.3g} with these settings", ratio_text(mu), *limit);
  return fit;
}

/// Schemes that iterate or include the added mass.
Fit stable(const v1::Case& the_case, const SceneNumbers& scene, const std::string& name, bool iterates,
           const std::string& cost) {
  const auto mu = scene.largest(&BodyNumbers::added_mass_ratio);
  const bool inertial = name.ends_with("inertial");
  if (inertial && the_case.fluid().source() == v1::Fluid::deviation)
    return {.name = name,
            .why = "the source deviation does not depend on the velocity: there is no added mass"};
  const std::string why = waves(the_case, scene, iterates);
  if (!why.empty()) return {.name = name, .why = why};
  if (late(the_case.coupling()))
    return {.name = name,
            .fits = mu && *mu < late_limit,
            .why = fmt::format("{}, limit {:g} with mean and ramped; {}", ratio_text(mu), late_limit, cost)};
  return {.name = name,
          .fits = true,
          .why = fmt::format("{}, no limit{}; {}", ratio_text(mu), inertial ? " for the included modes" : "",
                             cost)};
}

/// A scheme with its settings, and the reason for it.
struct Choice {
  std::string scheme, why;
};

Choice recommended_scheme(const v1::Case& the_case, const SceneNumbers& scene) {
  const std::string iterated = "strong with coupling.velocity = \"end\"";
  const auto mu = scene.largest(&BodyNumbers::added_mass_ratio);
  const auto limit = weak_limit(the_case.coupling());
  if (the_case.solid().model() == v1::SolidModel::rigid)
    return {"weak", "rigid bodies do not respond to the load"};
  if (const std::string why = waves(the_case, scene, false); !why.empty()) return {iterated, why};
  if (!mu) return {"auto", "there is no estimate of mu before the run; this scheme measures it"};
  if (!limit) return {"auto", "the limit of weak is not known with these settings"};
  const auto against = [&](const char* how) {
    return fmt::format("mu of about {:.3g} {} {:.3g}, the limit of weak with these settings", *mu, how,
                       *limit);
  };
  if (*mu >= *limit) return {iterated, against("exceeds")};
  if (*mu > *limit / 2) return {"auto", against("is near")};
  return {"weak", against("is at most half of")};
}

}  // namespace

std::optional<double> weak_limit(const v1::Coupling& coupling) {
  const bool ends = coupling.velocity() == v1::Coupling::end;
  const bool ramped = coupling.load() == v1::Coupling::ramped;
  if (coupling.prediction() == v1::Coupling::extrapolated) {
    if (ends && !ramped) return 1.0 / 3;
    return {};
  }
  if (ends) return ramped ? 2 : 1;
  return ramped ? 1.5 : 2;
}

std::vector<Fit> scheme_fits(const v1::Case& the_case, const SceneNumbers& scene) {
  const std::string why = waves(the_case, scene, true);
  return {
      weak(the_case, scene),
      stable(the_case, scene, "weak_inertial", false, "1.2 times the cost of weak"),
      stable(the_case, scene, "strong", true, "1.7 to 3 times the cost of weak"),
      stable(the_case, scene, "strong_inertial", true, "1.3 to 2.5 times the cost of weak"),
      {.name = "auto",
       .fits = why.empty(),
       .why = why.empty() ? "starts as weak, measures mu in every tenth window, changes to a stable scheme"
                          : why + ": it has no stable scheme"}};
}

std::string recommendation(const v1::Case& the_case, const SceneNumbers& scene) {
  const std::vector<Fit> models = model_fits(the_case, scene);
  const bool asked = std::any_of(the_case.output().probe().begin(), the_case.output().probe().end(),
                                 [](const v1::Probe& p) { return p.quantity() == v1::Probe::displacement; });
  // The cheapest first; a rigid body has no displacement.
  const auto best = std::find_if(models.begin(), models.end(), [&](const Fit& fit) {
    return fit.fits && !(asked && fit.name == "rigid" && the_case.solid().has_young_modulus());
  });
  require(best != models.end(), "no structural model fits: state solid.young_modulus or solid.sprung.spring");
  v1::Case with = the_case;
  v1::SolidModel::Word word{};
  v1::SolidModel::Word_Parse(best->name, &word);
  with.mutable_solid()->set_model(word);
  const std::string why = waves(with, scene, false);
  if (why.empty() || with.fluid().source() == v1::Fluid::time_scale) {
    const Choice choice = recommended_scheme(with, scene);
    return fmt::format("Use the model {} and the scheme {}: {}; {}.", best->name, choice.scheme, best->why,
                       choice.why);
  }
  with.mutable_fluid()->set_source(v1::Fluid::time_scale);
  const Choice choice = recommended_scheme(with, scene_numbers(with, scene.dry_frequency));
  return fmt::format("Use the source time_scale, the model {} and the scheme {}: {}; {}; {}.", best->name,
                     choice.scheme, why, best->why, choice.why);
}

}  // namespace cosurge
