#include "coupler/selftest_command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "coupler/say.hpp"
#include "coupler/simulation.hpp"
#include "coupler/swing.hpp"

namespace cosurge {
namespace {

constexpr double spacing = 0.005, width = 0.1, height = 0.2, floor_height = 0.02;  // m
constexpr double water_mass = 1000 * width * height;                               // kg per metre of width
constexpr double stiffness = 9474.8;                                               // N/m
constexpr double gravity = 9.81;
constexpr double push = 18.95;  // [N] in addition to the weights: the piston oscillates about 2 mm higher

void set_box(v1::Box& box, double x0, double y0, double x1, double y1) {
  for (const double value : {x0, y0}) box.add_min(value);
  for (const double value : {x1, y1}) box.add_max(value);
}

/// The case `sprung_piston` with a piston of `mass` [kg].
v1::Case piston(double mass, v1::Coupling::Scheme scheme) {
  v1::Case c;
  c.set_title("selftest");
  for (const double g : {0.0, -gravity}) c.add_gravity(g);
  c.mutable_time()->set_end(0.6);
  c.mutable_time()->set_window(5e-4);
  c.mutable_time()->set_stepping(v1::Time::fixed);
  v1::Fluid& fluid = *c.mutable_fluid();
  fluid.set_spacing(spacing);
  fluid.set_source(v1::Fluid::mixed);
  fluid.set_gradient(v1::Fluid::conserving);
  set_box(*fluid.mutable_tank(), 0, 0, width, 0.3);
  v1::Shape& water = *fluid.add_water();
  for (const double value : {0.0, floor_height}) water.add_min(value);
  for (const double value : {width, floor_height + height}) water.add_max(value);
  v1::Solid& solid = *c.mutable_solid();
  solid.set_model(v1::SolidModel::sprung);
  solid.set_density(1000);
  set_box(*solid.add_body()->mutable_box(), 0, 0, width, floor_height);
  solid.mutable_sprung()->set_mass(mass);
  v1::Spring& spring = *solid.mutable_sprung()->add_spring();
  spring.set_motion(v1::Spring::y);
  spring.set_stiffness(stiffness);
  spring.set_preload((mass + water_mass) * gravity + push);
  c.mutable_coupling()->set_scheme(scheme);
  c.mutable_coupling()->set_velocity(v1::Coupling::end);
  c.mutable_output()->set_frame_interval(0.6);
  v1::Probe& probe = *c.mutable_output()->add_probe();
  probe.set_name("piston");
  probe.set_quantity(v1::Probe::displacement);
  for (const double value : {width / 2, floor_height}) probe.add_position(value);
  return c;
}

struct Outcome {
  bool ended = true;
  double created = 0;
  double half_period = 0;  // time from the start, at rest in the lowest position, to the first maximum [s]
};

Outcome run(double mass, v1::Coupling::Scheme scheme) {
  Simulation simulation(piston(mass, scheme));
  simulation.begin();
  Swing swing(simulation.coupler());
  simulation.observe(swing);
  Outcome outcome;
  try {
    simulation.run();
  } catch (const std::exception&) {
    outcome.ended = false;
  }
  outcome.created = swing.created();
  outcome.half_period = swing.peak_time();
  return outcome;
}

bool report(bool ok, const std::string& text) {
  say("{}  {}\n", ok ? "ok    " : "FAILED", text);
  std::fflush(stdout);
  return ok;
}

/// The first half swing against pi sqrt((m + rho H) / k).
bool check_frequency(double mass, v1::Coupling::Scheme scheme) {
  constexpr double near = 0.08;  // tolerance; water of 40 particles' depth lacks 9 % of its added mass
  const double exact = std::sqrt(stiffness / (mass + water_mass)) / (2 * std::numbers::pi);
  const double found = 0.5 / run(mass, scheme).half_period;
  return report(std::abs(found / exact - 1) < near,
                fmt::format("{}, water {:.3g} times the piston: {:.3f} Hz, theory {:.3f} Hz",
                            v1::Coupling::Scheme_Name(scheme), water_mass / mass, found, exact));
}

/// `weak` with the velocity at the end and a held load is stable up to a ratio of 1.
bool check_limit(double ratio, bool stable) {
  constexpr double created = 0.08;  // share of the work: stable runs have less, unstable ones more
  const Outcome outcome = run(water_mass / ratio, v1::Coupling::weak);
  const bool found = outcome.ended && outcome.created < created;
  return report(found == stable, fmt::format("weak, water {:.3g} times the piston: {}, theory: {}", ratio,
                                             found ? "stable" : "unstable", stable ? "stable" : "unstable"));
}

}  // namespace

int selftest_command() {
  bool ok = check_frequency(40, v1::Coupling::weak);
  ok = check_frequency(10, v1::Coupling::strong) && ok;
  ok = check_frequency(10, v1::Coupling::weak_inertial) && ok;
  ok = check_limit(0.5, true) && ok;
  ok = check_limit(2, false) && ok;
  return ok ? 0 : 1;
}

}  // namespace cosurge
