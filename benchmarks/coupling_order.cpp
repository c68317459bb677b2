// Order in time of the coupling schemes, measured on the sprung piston under a lumped column of water. The
// schemes are those of the programs; water and structure are a few lines. benchmarks/coupling_theory.py
// computes the theory.
//
// build/release/bin/coupling_order > docs/tables/coupling_order.csv
#include <fmt/core.h>

#include <cmath>

#include "tests/support/piston_swing.hpp"

int main() {
  using namespace cosurge;
  using Coupling = v1::Coupling;
  const auto order = [](double coarse, double fine) {
    return std::abs(fine) > 1e-9 ? fmt::format("{:.2f}", std::log2(std::abs(coarse / fine))) : "exact";
  };
  fmt::print("# build/release/bin/coupling_order > docs/tables/coupling_order.csv\n");
  fmt::print("scheme,velocity,load,substeps,windows,frequency,order,lost,order_lost,created\n");
  for (const testing::CouplingWords& words :
       {testing::CouplingWords{Coupling::weak, Coupling::end, Coupling::held},
        {Coupling::weak, Coupling::mean, Coupling::held},
        {Coupling::weak, Coupling::end, Coupling::ramped},
        {Coupling::weak, Coupling::mean, Coupling::ramped},
        {Coupling::weak_inertial, Coupling::end, Coupling::held},
        {Coupling::strong, Coupling::end, Coupling::held},
        {Coupling::strong, Coupling::mean, Coupling::held}}) {
    for (const int substeps : {1, 400}) {
      testing::PistonSwing coarser{};
      for (const int windows : {25, 50, 100, 200}) {
        const testing::PistonSwing now = testing::piston_swing(words, 0.5, windows, substeps);
        const bool first = windows == 25;
        fmt::print("{},{},{},{},{},{:.3e},{},{:.3e},{},{:.3e}\n", Coupling::Scheme_Name(words.scheme),
                   Coupling::Velocity_Name(words.velocity), Coupling::LoadPath_Name(words.load), substeps,
                   windows, now.frequency, first ? "" : order(coarser.frequency, now.frequency), now.lost,
                   first ? "" : order(coarser.lost, now.lost), now.created);
        coarser = now;
      }
    }
  }
}
