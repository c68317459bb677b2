#include "coupler/advise/advise_command.hpp"

#include <algorithm>
#include <numbers>

#include "common/case/carriers.hpp"
#include "common/case/case_doubts.hpp"
#include "common/case/case_file.hpp"
#include "common/case/several_solids.hpp"
#include "common/case/window_sizes.hpp"
#include "common/error.hpp"
#include "common/solvers.hpp"
#include "coupler/advise/fit.hpp"
#include "coupler/measured_size.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

/// Frequency in vacuum as the structure's set-up states it [Hz]: the slowest oscillation of each body, the
/// highest of all; 0 where nothing oscillates. Rigid bodies with a modulus: that of finite elements.
double dry_frequency(v1::Case the_case) {
  the_case.mutable_time()
      ->clear_window();  // the solver chooses its windows, for which it needs the frequency
  if (the_case.solid().model() == v1::SolidModel::rigid && the_case.solid().has_young_modulus())
    the_case.mutable_solid()->set_model(v1::SolidModel::fem);
  Interface no_points;
  no_points.dimension = the_case.dimension();
  InterfaceMotion motion;
  make_solid_solver()->initialize(the_case, no_points, InterfaceLoad::zero(the_case.dimension(), 0), motion);
  return motion.frequency / (2 * std::numbers::pi);
}

/// Whether walls or bodies have a prescribed motion.
bool is_driven(const v1::Case& the_case) {
  const auto thing_moves = [&](const auto& thing) { return moves(thing.motion()); };
  const auto& obstacles = the_case.fluid().obstacle();
  const auto& bodies = the_case.solid().body();
  return moves(the_case.fluid().tank_motion()) ||
         std::any_of(obstacles.begin(), obstacles.end(), thing_moves) ||
         std::any_of(bodies.begin(), bodies.end(), thing_moves);
}

void say_water(const v1::Case& the_case, const SceneNumbers& scene) {
  say("  {:<12} H = {:.4g} m, {:.4g} layers; V = sqrt(2 g H) = {:.3g} m/s\n", "water", scene.head,
      scene.layers, scene.speed);
  if (scene.cauchy) say("  {:<12} {:.3g} = rho V^2 / E\n", "Cauchy", *scene.cauchy);
  if (scene.reynolds) say("  {:<12} {:.3g} = V H / nu\n", "Reynolds", *scene.reynolds);
  say("  {:<12} {:.3g} = V dt / l0 in windows of {:.3g} s; fluid.courant is {:g}\n", "Courant", scene.courant,
      scene.window, courant_number(the_case.fluid(), false));
}

void say_body(const v1::Case& the_case, const BodyNumbers& body, int b) {
  const double spacing = the_case.fluid().spacing();
  const char* unit = the_case.dimension() == 2 ? "kg/m" : "kg";
  say("  solid.body.{}: {:.4g} {}, displaces {:.4g} {} of water; {:.4g} m thick, {:.3g} layers\n", b,
      body.mass, unit, body.displaced, unit, body.thickness, body.thickness / spacing);
  if (body.added_mass_ratio)
    say("    added mass / mass    mu about {:.3g}\n", *body.added_mass_ratio);
  else
    say("    added mass / mass    no estimate: at the start no water lies above it or beside it\n");
  if (body.gain) say("    thickness waves      gain {:.3g}\n", *body.gain);
  if (body.deflection)
    say("    static deflection    {:.3g} m: {:.3g} of the thickness, {:.3g} of a spacing\n", *body.deflection,
        *body.deflection / body.thickness, *body.deflection / spacing);
}

void say_frequency(const SceneNumbers& scene) {
  if (scene.dry_frequency == 0) return say("  {:<12} nothing oscillates\n", "frequency");
  say("  {:<12} dry {:.4g} Hz, a period of {:.0f} windows\n", "frequency", scene.dry_frequency,
      1 / (scene.dry_frequency * scene.window));
  if (!scene.wet_frequency) return say("  {:<12} wet: no estimate, see docs/speed_accuracy.md\n", "");
  say("  {:<12} wet about {:.4g} Hz, a period of {:.0f} windows\n", "", *scene.wet_frequency,
      1 / (*scene.wet_frequency * scene.window));
}

void say_fits(const char* title, const std::vector<Fit>& fits) {
  say("{}\n", title);
  for (const Fit& fit : fits) say("  {:<16} {:<5} {}\n", fit.name, fit.fits ? "fits" : "no", fit.why);
}

}  // namespace

namespace {

/// The advice for a case of one structure.
void advise(const v1::Case& the_case) {
  const SceneNumbers scene = scene_numbers(the_case, dry_frequency(the_case));
  for (const std::string& warning : coarse_spacings(the_case, scene)) say("warning: {}\n", warning);
  say("{}\n", the_case.title());
  if (is_driven(the_case))
    say("  note: the numbers do not include the prescribed motions of walls; V and the load may be larger\n");
  say_water(the_case, scene);
  for (int b = 0; b < the_case.solid().body_size(); ++b)
    say_body(the_case, scene.bodies[static_cast<std::size_t>(b)], b);
  say_frequency(scene);
  say_fits("models", model_fits(the_case, scene));
  say_fits("coupling schemes, with the other settings of the case", scheme_fits(the_case, scene));
  say("{}\n", recommendation(the_case, scene));
}

}  // namespace

void advise_command(const std::string& case_path, const std::vector<std::string>& overrides) {
  const v1::Case the_case = load_case(case_path, overrides);
  require(the_case.has_fluid() && the_case.has_solid(),
          "{}: has no {}; cosurge advise compares water with a structure. cosurge check estimates its size",
          case_path, the_case.has_fluid() ? "[solid]" : "[fluid]");
  for (const std::string& doubt : doubts(the_case)) say("warning: {}\n", doubt);
  if (!has_several_solids(the_case)) {
    advise(the_case);
  } else {
    say("the case has {} structures: the advice looks at each as if it stood alone in the water; one "
        "coupling "
        "scheme must fit all\n",
        the_case.solids_size());
    for (int k = 0; k < the_case.solids_size(); ++k) {
      say("\nstructure {}\n", the_case.solids(k).name());
      advise(case_of_solid(the_case, k));
    }
  }
  say("size\n");
  Simulation simulation(the_case);
  say_size(the_case, measure_size(simulation));
}

}  // namespace cosurge
