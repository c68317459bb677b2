#include "common/case/probe_columns.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace cosurge {
namespace {

constexpr std::array<std::string_view, 12> fluid_columns = {"ppe_iterations",
                                                            "ppe_residual",
                                                            "ppe_unknowns",
                                                            "modes_iterations",
                                                            "modes_mass_ratio",
                                                            "max_speed",
                                                            "kinetic_energy",
                                                            "gravity_energy",
                                                            "front",
                                                            "lost",
                                                            "inside_bodies",
                                                            "water"};
// Columns of quantities with a direction, named like those of displacement probes.
constexpr std::array<std::string_view, 6> solid_columns = {
    "load_x", "load_y", "load_z", "contact_load_x", "contact_load_y", "contact_load_z"};

}  // namespace

std::string probe_group(const v1::Probe& probe) {
  return probe.quantity() == v1::Probe::displacement ? "solid" : "fluid";
}

std::vector<std::string> probe_columns(const v1::Probe& probe, int dimension) {
  const bool has_direction = probe.quantity() == v1::Probe::displacement ||
                             probe.quantity() == v1::Probe::force ||
                             (probe.quantity() == v1::Probe::moment && dimension == 3);
  if (!has_direction) return {probe.name()};
  std::vector<std::string> columns;
  for (int axis = 0; axis < dimension; ++axis) columns.push_back(probe.name() + "_" + "xyz"[axis]);
  return columns;
}

bool is_own_column(const std::string& group, const std::string& name) {
  const auto in = [&](const auto& list) { return std::find(list.begin(), list.end(), name) != list.end(); };
  if (group == "solid") return in(solid_columns);
  return in(fluid_columns) || name.starts_with("lost_") || name.starts_with("seconds_") ||
         name == "cpu_seconds";
}

}  // namespace cosurge
