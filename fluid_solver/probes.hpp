// The probes of the water, measured in every window.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fluid_solver/load.hpp"
#include "fluid_solver/mps.hpp"
#include "fluid_solver/probe.hpp"
#include "fluid_solver/water_level.hpp"

namespace cosurge::fluid {

/// Data of the last window for the probes.
struct ProbeInput {
  const InterfaceMotion& motion;  ///< motion of the bodies
  const InterfaceLoad& load;      ///< load on the bodies
  double end;                     ///< time [s]
};

/// All probes of the water. Their values are read after every window.
template <int dim>
class Probes {
 public:
  /// @throws Error where a probe of a body's pressure has no wet face within a spacing.
  Probes(const std::vector<Probe<dim>>& probes, const Mps<dim>& mps, const Interface& interface);

  /// Name and unit of each value.
  const std::vector<Column>& columns() const { return columns_; }

  std::vector<double> read(const ProbeInput& input);

 private:
  using Vector = Vec<dim>;
  using ReadLoad = std::function<Load<dim>(const ProbeInput&)>;

  void add(const Probe<dim>& probe, const Interface& interface);
  void add_value(const std::string& name, const std::string& unit,
                 std::function<double(const ProbeInput&)> read);
  void add_pressure(const Probe<dim>& probe, const Interface& interface);
  void add_level(const Probe<dim>& probe);
  void add_load(const Probe<dim>& probe, const Interface& interface);
  ReadLoad load_on(const Probe<dim>& probe, const Interface& interface);

  const Mps<dim>& mps_;
  std::vector<Column> columns_;
  std::vector<std::function<void(const ProbeInput&, std::vector<double>&)>> readers_;
  bool has_levels_ = false;
  bool has_wall_loads_ = false;
  WaterParts parts_;                 // connected parts of the water, found in every window for level probes
  std::vector<std::int32_t> place_;  // places of the particles by id, found in every window for wall loads
};

}  // namespace cosurge::fluid
