// Limits of the water's stability and accuracy: tables of docs/stability.md.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>

#include "common/error.hpp"
#include "common/threads.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/turning_patch.hpp"

namespace cosurge::fluid {
namespace {

using test::box_of;
using test::filled;
using test::tank_of_water;
using test::TurningPatch;

constexpr double density = 1000, g = 9.81;
constexpr double largest_courant = 0.5;  // largest value that a case may have

/// Rms deviation of a history from its mean over `around` [s] before and after.
double noise(const std::vector<double>& t, const std::vector<double>& p, double around, double from) {
  double sum = 0;
  int count = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (t[k] < from) continue;
    double mean = 0;
    int near = 0;
    for (std::size_t m = 0; m < t.size(); ++m)
      if (std::abs(t[m] - t[k]) <= around) mean += p[m], ++near;
    sum += std::pow(p[k] - mean / near, 2);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// Kinetic energy, and energy of the weight [J/m].
double energy(const Mps<2>& mps, double l0) {
  double sum = 0;
  for (int i = 0; i < mps.particles().size(); ++i)
    if (mps.particles().kind[i] == Kind::fluid)
      sum += 0.5 * mps.particles().u[i].squaredNorm() + g * mps.particles().x[i][1];
  return density * l0 * l0 * sum;
}

struct Choices {
  const char* name;
  v1::Fluid::Source source;
  v1::Fluid::Gradient gradient;
};

/// A column that collapses and meets the wall opposite at 0.25 s, until 0.3 s, on a lattice of 4 mm.
void collapse(const Choices& source, double alpha, double courant) {
  constexpr double l0 = 0.004, width = 0.148, height = 0.292, end = 0.3, quiet = 0.02;
  v1::Fluid fluid = tank_of_water(l0, box_of({0, 0}, {0.584, 0.584}), {box_of({0, 0}, {width, height})});
  fluid.set_source(source.source);
  fluid.set_gradient(source.gradient);
  fluid.set_compressibility(alpha);
  fluid.set_courant(std::min(courant, largest_courant));
  fluid.set_propagation_speed(1);
  auto mps = test::mps_of<2>(fluid, nullptr, Vec<2>(0, -g));
  const double start = energy(mps, l0);
  std::vector<double> times, pressures;
  const double beyond = std::max(1.0, courant / largest_courant);  // the steps that the water asks for
  double t = 0, dt = courant * std::sqrt(l0 / g), volume = 0, gained = 0;
  std::string state = "stable";
  const std::clock_t clock = std::clock();
  try {
    while (t < end) {
      const StepReport step = mps.step(t, dt);
      t += dt;
      dt = beyond * step.max_window;
      double sum = 0;
      int points = 0;
      for (int i = 0; i < mps.particles().size(); ++i)
        if (const Vec<2>& x = mps.particles().x[i];
            mps.particles().kind[i] == Kind::wall && x[1] < 0 && x[1] > -l0 && x[0] > 0 && x[0] < 0.04)
          sum += mps.particles().p[i], ++points;
      times.push_back(t);
      pressures.push_back(sum / points);
      gained = std::max(gained, energy(mps, l0) / start - 1);
      if (t > quiet) volume = std::max(volume, std::abs(filled(mps, l0, {{0.012, 0.012}, {0.08, 0.04}}) - 1));
    }
  } catch (const NumericalError&) {
    state = "blown_up";
  }
  if (state == "stable" && mps.initial_size() > mps.particles().size()) state = "lost";
  fmt::print("{},{:g},{:g},{},{:.4f},{},{:.4f},{:.4f},{:.4f},{},{:.2f}\n", source.name, alpha, courant, state,
             t, times.size(), noise(times, pressures, 0.005, quiet) / (density * g * height), volume, gained,
             mps.initial_size() - mps.particles().size(),
             static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
  std::fflush(stdout);
}

void column() {
  fmt::print("source,compressibility,courant,state,end,windows,noise,volume,gained,lost,seconds\n");
  for (const Choices& source : {Choices{"deviation p_min", v1::Fluid::deviation, v1::Fluid::p_min},
                                Choices{"mixed corrected", v1::Fluid::mixed, v1::Fluid::corrected},
                                Choices{"time_scale corrected", v1::Fluid::time_scale, v1::Fluid::corrected}})
    for (const double alpha : {1e-10, 1e-9, 1e-8, 1e-7, 1e-6})
      for (const double courant : {0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0}) collapse(source, alpha, courant);
}

/// Filled share of the middle of the patch, angular momentum and energy relative to the start, and the
/// pressure in the middle, averaged over a tenth of a second.
void turning_patch(const TurningPatch::Choice& choice) {
  constexpr double end = 2, rho_omega2_L2 = 1000;
  constexpr int interval = 25;
  TurningPatch patch(choice);
  const auto print = [&](double filled, double angular_momentum, double energy, double pressure) {
    fmt::print("{},{:g},{:g},{:.3f},{:.4f},{:.4f},{:.4f},{:.4f}\n", v1::Fluid::Gradient_Name(choice.gradient),
               choice.shifting, choice.lowest_pressure, patch.time(), filled, angular_momentum, energy,
               pressure / rho_omega2_L2);
    std::fflush(stdout);
  };
  try {
    while (patch.time() < end - 1e-6) {
      double pressure = 0;
      for (int k = 0; k < interval; ++k) {
        patch.step();
        pressure += patch.pressure() / interval;
      }
      print(patch.filled(), patch.angular_momentum(), patch.energy(), pressure);
    }
  } catch (const NumericalError&) {
    print(NAN, NAN, NAN, NAN);
  }
}

void patch() {
  fmt::print("gradient,shifting,lowest_pressure,time,filled,angular_momentum,energy,pressure\n");
  for (const double lowest : {0.0, -1e5})
    for (const auto gradient : {v1::Fluid::p_min, v1::Fluid::conserving, v1::Fluid::corrected})
      for (const double shifting : {0.0, 0.1})
        turning_patch(
            {.particles = 40, .gradient = gradient, .shifting = shifting, .lowest_pressure = lowest});
}

}  // namespace
}  // namespace cosurge::fluid

int main(int count, char** arguments) {
  using namespace cosurge;
  const std::map<std::string, std::function<void()>> tables = {{"column", fluid::column},
                                                               {"patch", fluid::patch}};
  CLI::App app("Writes one table of the limits of the water to standard output, as CSV");
  std::string table;
  app.add_option("table", table)->required()->check(CLI::IsMember(tables));
  CLI11_PARSE(app, count, arguments);
  set_threads(1);
  fmt::print("# build/release/bin/fluid_limits {}\n", table);
  tables.at(table)();
}
