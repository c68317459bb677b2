// Tables of docs/verification.md: the structural models compared with theory, and their cost.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>

#include "common/threads.hpp"
#include "tests/support/impact.hpp"

namespace cosurge {
namespace {

/// The six materials of the plate of Amaro & Cheng.
const std::vector<Cantilever> plates = [] {
  std::vector<Cantilever> all = {{0.080, 0.012, 2500, 1e6, 0}};
  for (const double E : {2e7, 2e8, 2e9, 2e10, 2e11}) all.push_back({0.080, 0.012, 7800, E, 0.3});
  return all;
}();

/// A model, as in a case.
struct Model {
  std::string name;
  v1::SolidModel::Word word;
  v1::SolidMps::Pairs pairs = v1::SolidMps::corrected;

  PlateCase plate(const Cantilever& of, int particles = 12) const {
    return {.model = word, .pairs = pairs, .plate = of, .particles = particles};
  }
  bool of_particles() const { return word == v1::SolidModel::mps || word == v1::SolidModel::hamiltonian; }
};

std::vector<Model> models = {{"fem", v1::SolidModel::fem},
                             {"modal", v1::SolidModel::modal},
                             {"hamiltonian", v1::SolidModel::hamiltonian},
                             {"mps", v1::SolidModel::mps},
                             {"mps_paper", v1::SolidModel::mps, v1::SolidMps::paper}};

double percent(double measured, double exact) { return 100 * (measured / exact - 1); }

void print_line(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// First frequency of the plate of Amaro & Cheng.
void frequencies() {
  print_line("model,young_modulus_Pa,poisson_ratio,particles_of_thickness,f1_Hz,timoshenko_Hz,off_percent");
  for (const Model& model : models) {
    for (const Cantilever& plate : plates) {
      for (const int particles : {6, 12, 24}) {
        const double exact = plate.timoshenko();
        const double f1 = swing_frequency(model.plate(plate, particles), exact, {1, 0});
        print_line(fmt::format("{},{:g},{},{},{:.5g},{:.5g},{:.2f}", model.name, plate.young_modulus,
                               plate.poisson_ratio, particles, f1, exact, percent(f1, exact)));
      }
    }
  }
}

/// Speed of waves along a bar with Poisson's ratio 0, sqrt(E / rho), from the periods 4 L / c of two clamped
/// ones: their difference does not depend on the ends. Period of Gray's cantilever.
void waves() {
  print_line(
      "model,particles_of_thickness,bar_speed_m_s,exact_m_s,off_percent,gray_period_s,thin_plate_s,off_"
      "percent");
  for (const Model& model : models) {
    for (const int particles : {6, 12, 24}) {
      const double exact = 20;
      double period[2];
      for (const int k : {0, 1}) {
        const Cantilever bar = {0.080 * (k + 1), 0.012, 2500, 1e6, 0};
        period[k] = 1 / swing_frequency(model.plate(bar, particles), exact / (4 * bar.length), {0, 1});
      }
      const double speed = 4 * 0.080 / (period[1] - period[0]);
      const Cantilever gray = {0.2, 0.02, 1000, 2e6, 0.3975};
      const double swing = 1 / swing_frequency(model.plate(gray, particles), gray.timoshenko(), {1, 0});
      print_line(fmt::format("{},{},{:.4f},{:g},{:.2f},{:.5f},{:.5f},{:.2f}", model.name, particles, speed,
                             exact, percent(speed, exact), swing, 1 / gray.euler_bernoulli(),
                             percent(swing, 1 / gray.euler_bernoulli())));
    }
  }
}

/// A load of the elastica: p L^2 / EI with the deflection w / L and shortening u / L of the end (Bisshopp &
/// Drucker 1945, Mattiasson 1981 for an end load; a uniform dead load from the same equations).
struct Elastica {
  const char* kind;
  double load, w, u;
};

/// Large deflection under dead loads, brought on slowly and damped to rest.
void elastica() {
  print_line("model,particles_of_thickness,load,p,w_over_L,off_percent,u_over_L,off_percent");
  const std::vector<Elastica> cases = {{"end", 1, .30172, .05643},     {"end", 4, .66996, .32894},
                                       {"end", 10, .81061, .55500},    {"uniform", 1, .12347, .00875},
                                       {"uniform", 4, .42516, .10989}, {"uniform", 10, .70020, .34365}};
  const Cantilever plate = {0.240, 0.012, 2500, 1e6, 0};
  for (const Model& model : models) {
    if (model.word == v1::SolidModel::modal) continue;  // small deflections
    for (const int particles : {6, 12}) {
      for (const Elastica& exact : cases) {
        PlateCase from = model.plate(plate, particles);
        from.damping_ratio = 0.7;
        Plate run(from);
        const bool end = exact.kind == std::string("end");
        const double whole = exact.load * plate.rigidity() / (plate.length * plate.length);
        const double share = whole / (end ? particles : static_cast<double>(run.points()));
        const double loaded_from = end ? plate.length - from.spacing() : 0, period = 1 / plate.timoshenko();
        constexpr int windows = 200, ramp = 80;
        for (int k = 1; k <= windows; ++k) {
          const double force = share * std::min(1.0, static_cast<double>(k) / ramp);
          run.advance(6 * period / windows,
                      [&](const Vec<2>& X) { return Vec<2>(X[1] > loaded_from ? force : 0, 0); });
        }
        const double w = run.tip()[0] / plate.length, u = -run.tip()[1] / plate.length;
        print_line(fmt::format("{},{},{},{:g},{:.5f},{:.2f},{:.5f},{:.2f}", model.name, particles, exact.kind,
                               exact.load, w, percent(w, exact.w), u, percent(u, exact.u)));
      }
    }
  }
}

/// Total energy of the undamped plate under gravity across it, over a second. `modal` in its range, the
/// others with a wide swing.
void energy() {
  print_line("model,tip_amplitude_m,ripple,drift_per_second");
  for (const Model& model : models) {
    PlateCase from = model.plate(plates[0]);
    from.gravity_x = model.word == v1::SolidModel::modal ? 1.0 : 15.0;
    Plate run(from);
    const double window = 5e-4;
    const int windows = 2000, part = 340;  // two periods
    double kinetic = 0, tip = 0, low = 0, high = 0, first = 0, last = 0;
    for (int k = 0; k < windows; ++k) {
      run.advance(window, [](const Vec<2>&) { return Vec<2>(0, 0); });
      const double now = run.energy();
      kinetic = std::max(kinetic, run.value("kinetic_energy"));
      tip = std::max(tip, run.tip()[0]);
      low = std::min(low, now);
      high = std::max(high, now);
      first += k < part ? now / part : 0;
      last += k >= windows - part ? now / part : 0;
    }
    const double seconds = window * (windows - part);
    print_line(fmt::format("{},{:.4f},{:.1e},{:.1e}", model.name, tip / 2, (high - low) / kinetic,
                           (last - first) / kinetic / seconds));
  }
}

double cpu_of(const std::function<void()>& work) {
  const auto start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Deflection of the plate's end under 1 Pa, brought on smoothly over eight periods [m].
double deflection(const PlateCase& from) {
  Plate run(from);
  constexpr int per_period = 50, ramp = 8 * per_period, mean = 2 * per_period;
  const double window = 1 / (from.plate.timoshenko() * per_period), force = from.spacing();
  double sum = 0;
  for (int k = 1; k <= ramp + mean; ++k) {
    const double s = std::min(1.0, static_cast<double>(k) / ramp), load = force * s * s * (3 - 2 * s);
    run.advance(window, [&](const Vec<2>&) { return Vec<2>(load, 0); });
    if (k > ramp) sum += run.tip()[0] / mean;
  }
  return sum;
}

/// Deflection of the plate of Amaro & Cheng (1 MPa) under a pressure on its face, towards Poisson's ratio
/// 1/2, over that of eight elements through the thickness. On 6 and 12 particles, two and four elements.
void incompressible() {
  print_line("model,poisson_ratio,particles_of_thickness,deflection_over_fine_elements,over_beam");
  for (const double nu : {0.3, 0.4, 0.45, 0.49, 0.499}) {
    const Cantilever plate = {0.080, 0.012, 2500, 1e6, nu};
    const double exact =
        deflection({.model = v1::SolidModel::fem, .plate = plate, .particles = 24, .only_face = true});
    for (const Model& model : models) {
      if (model.pairs == v1::SolidMps::paper) continue;
      for (const int particles : {6, 12}) {
        PlateCase from = model.plate(plate, particles);
        from.only_face = true;
        const double tip = deflection(from);
        print_line(fmt::format("{},{:g},{},{:.4f},{:.4f}", model.name, nu, particles, tip / exact,
                               tip / plate.deflection()));
      }
    }
  }
}

/// CPU time of one second of the plate of Amaro & Cheng in windows of 0.2 ms under a small varying load on
/// its face; particles, sub-steps, and what a sub-step of one particle takes; deflection under a pressure on
/// the face.
void cost() {
  print_line(
      "model,young_modulus_Pa,substeps_per_s,cpu_seconds_per_s,ns_per_particle_and_substep,deflection_over_"
      "beam");
  for (const Model& model : models) {
    if (model.pairs == v1::SolidMps::paper) continue;  // costs as much as the corrected ones
    for (const Cantilever& plate : plates) {
      PlateCase from = model.plate(plate);
      from.only_face = true;
      from.viscosity = v1::SolidMps().viscosity();  // by default
      Plate run(from);
      const double window = 2e-4, small = 1e-3 * plate.length / plate.deflection() * from.spacing();
      int windows = 0;
      double cpu = 0, substeps = 0;
      while (cpu < 1) {
        cpu += cpu_of([&] {
          for (int k = 0; k < 20; ++k, ++windows) {
            const double load = small * std::sin(0.1 * windows);
            run.advance(window, [&](const Vec<2>&) { return Vec<2>(load, 0); });
            substeps += run.value("substeps");
          }
        });
      }
      const double physical = windows * window;
      const std::string each =
          model.of_particles()
              ? fmt::format("{:.2f}", 1e9 * cpu / (substeps * static_cast<double>(run.setup().particles)))
              : "";
      print_line(fmt::format("{},{:g},{:.4g},{:.4g},{},{:.4f}", model.name, plate.young_modulus,
                             substeps / physical, cpu / physical, each,
                             deflection(from) / plate.deflection()));
    }
  }
}

/// The impact on the rigid plate, as it was recorded, on a soft and on the stiffest plate: CPU, and where the
/// tip goes to.
void recorded() {
  print_line(
      "young_modulus_Pa,model,setup_seconds,cpu_seconds,mps_over_cpu,largest_tip_m,off_mps_percent,at_s,"
      "mean_off_mps_percent,apart_percent");
  std::vector<Model> by_cost = models;
  std::reverse(by_cost.begin(), by_cost.end());  // the costs of the others are relative to that of `mps`
  std::erase_if(by_cost, [](const Model& one) { return one.pairs == v1::SolidMps::paper; });
  const RecordedPressure pressure(impact_file);
  for (const Cantilever& plate : {plates[1], plates.back()}) {
    Impact beside;
    for (const Model& model : by_cost) {
      Impact impact;
      const double all = cpu_of([&] { impact = impact_on(model.plate(plate), pressure); });
      if (beside.tip.empty()) beside = impact;
      print_line(
          fmt::format("{:g},{},{:.2g},{:.4g},{:.4g},{:.5g},{:.2f},{:.4f},{:.2f},{:.1f}", plate.young_modulus,
                      model.name, all - impact.seconds, impact.seconds, beside.seconds / impact.seconds,
                      impact.largest(), percent(impact.largest(), beside.largest()), impact.at(),
                      percent(impact.mean(), beside.mean()), 100 * impact.apart(beside) / beside.largest()));
    }
  }
}

}  // namespace
}  // namespace cosurge

int main(int count, char** arguments) {
  using namespace cosurge;
  const std::map<std::string, std::function<void()>> tables = {{"frequencies", frequencies},
                                                               {"waves", waves},
                                                               {"elastica", elastica},
                                                               {"energy", energy},
                                                               {"cost", cost},
                                                               {"recorded", recorded},
                                                               {"incompressible", incompressible}};
  CLI::App app("Writes one table of the solid models to standard output, as CSV");
  std::string table;
  app.add_option("table", table)->required()->check(CLI::IsMember(tables));
  std::string model;
  std::vector<std::string> names;
  for (const Model& one : models) names.push_back(one.name);
  app.add_option("--model", model, "this one alone")->check(CLI::IsMember(names));
  CLI11_PARSE(app, count, arguments);
  if (!model.empty()) std::erase_if(models, [&](const Model& one) { return one.name != model; });
  fmt::print("# build/release/bin/solid_tables {}\n", table);
  set_threads(1);  // CPU seconds without waiting threads
  tables.at(table)();
}
