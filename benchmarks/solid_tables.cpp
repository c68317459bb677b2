// Tables of docs/verification.md: the solid models against theory, and what they cost.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "benchmarks/plate.hpp"

namespace cosurge {
namespace {

/// The six materials of the paper's plate.
const std::vector<Cantilever> plates = [] {
  std::vector<Cantilever> all = {{0.080, 0.012, 2500, 1e6, 0}};
  for (const double E : {2e7, 2e8, 2e9, 2e10, 2e11}) all.push_back({0.080, 0.012, 7800, E, 0.3});
  return all;
}();

const std::vector<v1::SolidModel::Word> models = {v1::SolidModel::fem, v1::SolidModel::modal,
                                                  v1::SolidModel::hamiltonian, v1::SolidModel::mps};

const std::string& name(v1::SolidModel::Word model) { return v1::SolidModel::Word_Name(model); }

void frequencies() {
  fmt::print("model,young_modulus_Pa,poisson_ratio,particles_of_thickness,f1_Hz,timoshenko_Hz,off_percent\n");
  for (const auto model : models) {
    for (const Cantilever& plate : plates) {
      for (const int particles : {6, 12, 24}) {
        const double f1 = first_frequency({.model = model, .plate = plate, .particles = particles});
        fmt::print("{},{:g},{},{},{:.5g},{:.5g},{:.2f}\n", name(model), plate.young_modulus,
                   plate.poisson_ratio, particles, f1, plate.timoshenko(),
                   100 * (f1 / plate.timoshenko() - 1));
        std::fflush(stdout);
      }
    }
  }
}

}  // namespace
}  // namespace cosurge

int main(int count, char** arguments) {
  using namespace cosurge;
  const std::map<std::string, std::function<void()>> tables = {{"frequencies", frequencies}};
  CLI::App app("Writes one table of the solid models to standard output, as CSV");
  std::string table;
  app.add_option("table", table)->required()->check(CLI::IsMember(tables));
  CLI11_PARSE(app, count, arguments);
  fmt::print("# build/release/bin/solid_tables {}\n", table);
  tables.at(table)();
}
