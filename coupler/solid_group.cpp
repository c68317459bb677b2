#include "coupler/solid_group.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "common/case/probe_columns.hpp"
#include "common/case/several_solids.hpp"
#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "coupler/structures_overlap.hpp"

namespace cosurge {
namespace {

constexpr std::array summed = {"kinetic_energy", "elastic_energy",   "gravity_energy",  "interface_work",
                               "substeps",       "seconds_substeps", "seconds_mapping", "cpu_seconds"};

/// Calls a function for a structure, and puts the structure's name in front of the messages of exceptions.
template <typename Action>
auto with_name(const std::string& name, const Action& action) {
  try {
    return action();
  } catch (const Interrupted&) {
    throw;
  } catch (const NumericalError& error) {
    throw NumericalError(fmt::format("{}: {}", name, error.what()));
  } catch (const std::exception& error) {
    throw Error(fmt::format("{}: {}", name, error.what()));
  }
}

/// The points on the bodies of one structure, with the numbers of these bodies in the structure's own case.
Interface interface_of(const v1::Case& the_case, const Interface& all, int solid,
                       std::vector<Eigen::Index>& points) {
  const int first = first_body(the_case, solid);
  Interface part{.dimension = all.dimension, .position = {}, .area = {}, .body = {}};
  for (Eigen::Index p = 0; p < all.points(); ++p) {
    const int body = all.body[static_cast<std::size_t>(p)] - first;
    if (body < 0 || body >= the_case.solids(solid).body_size()) continue;
    points.push_back(p);
    part.body.push_back(body);
  }
  part.position = all.position(Eigen::all, points);
  part.area = all.area(Eigen::all, points);
  return part;
}

std::set<std::string> columns_of_probes(const v1::Case& the_case) {
  std::set<std::string> names;
  for (const v1::Probe& probe : the_case.output().probe())
    if (probe.quantity() == v1::Probe::displacement)
      for (const std::string& column : probe_columns(probe, the_case.dimension())) names.insert(column);
  return names;
}

/// The name without a leading "solid_", which some solvers write.
std::string plain_name(const Array& array) {
  constexpr std::string_view prefix = "solid_";
  return array.name.starts_with(prefix) ? array.name.substr(prefix.size()) : array.name;
}

std::size_t particles_of(const Array& array) {
  return array.values.size() / static_cast<std::size_t>(array.components);
}

/// The array of the same name and components; null if there is none.
const Array* find(const Snapshot& snapshot, const Array& wanted) {
  const auto found = std::find_if(snapshot.begin(), snapshot.end(), [&](const Array& array) {
    return plain_name(array) == plain_name(wanted) && array.components == wanted.components;
  });
  return found == snapshot.end() ? nullptr : &*found;
}

}  // namespace

SolidGroup::SolidGroup(const std::vector<Entry>& solids) {
  for (const Entry& entry : solids) parts_.push_back({.name = entry.name, .solid = entry.solid});
}

Identity SolidGroup::identity() const {
  Identity all = parts_.front().solid->identity();
  bool same = true;
  std::vector<std::string> programs;
  for (const Part& part : parts_) {
    const Identity one = part.solid->identity();
    same = same && one.program == all.program && one.version == all.version;
    programs.push_back(fmt::format("{}: {} {}", part.name, one.program, one.version));
  }
  if (same) return all;
  all.program = fmt::format("{}", fmt::join(programs, ", "));
  all.version.clear();
  return all;
}

Setup SolidGroup::initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                             InterfaceMotion& motion) {
  const int dimension = the_case.dimension();
  const std::set<std::string> probes = columns_of_probes(the_case);
  motion = InterfaceMotion::at_rest(dimension, interface.points());
  places_ = interface.position;
  structure_.assign(static_cast<std::size_t>(interface.points()), 0);
  spacing_ = the_case.fluid().spacing();
  Setup setup;
  setup.window = std::numeric_limits<double>::infinity();
  std::vector<Setup> setups;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = parts_[k];
    part.points.clear();
    const Interface own = interface_of(the_case, interface, static_cast<int>(k), part.points);
    for (const Eigen::Index p : part.points) structure_[static_cast<std::size_t>(p)] = static_cast<int>(k);
    part.load = InterfaceLoad::zero(dimension, own.points());
    give(load, part);
    const Setup one = with_name(part.name, [&] {
      return part.solid->initialize(case_of_solid(the_case, static_cast<int>(k)), own, part.load,
                                    part.motion);
    });
    take(part, motion);
    for (const Column& column : one.columns)
      setup.columns.push_back(
          {probes.contains(column.name) ? column.name : part.name + "/" + column.name, column.unit});
    setup.particles += one.particles;
    setup.window = std::min(setup.window, one.window);
    if (one.substep > 0)
      setup.substep = setup.substep > 0 ? std::min(setup.substep, one.substep) : one.substep;
    setups.push_back(one);
  }
  add_sums(setups, setup);
  return setup;
}

void SolidGroup::add_sums(const std::vector<Setup>& setups, Setup& setup) {
  sums_.clear();
  for (const char* name : summed) {
    Sum sum;
    std::string unit;
    for (const Setup& one : setups) {
      const auto found = std::find_if(one.columns.begin(), one.columns.end(),
                                      [&](const Column& column) { return column.name == name; });
      if (found == one.columns.end()) continue;
      sum.push_back(static_cast<std::size_t>(found - one.columns.begin()));
      unit = found->unit;
    }
    if (sum.size() < setups.size()) continue;
    sums_.push_back(sum);
    setup.columns.push_back({name, unit});
  }
}

Report SolidGroup::advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) {
  Report report{.values = {}, .window = std::numeric_limits<double>::infinity()};
  motion.modes.clear();
  motion.frequency = 0;
  for (Part& part : parts_) {
    give(load, part);
    Report one = with_name(part.name, [&] { return part.solid->advance(window, part.load, part.motion); });
    take(part, motion);
    report.values.insert(report.values.end(), one.values.begin(), one.values.end());
    report.window = std::min(report.window, one.window);
    for (const std::string& note : one.notes) report.notes.push_back(part.name + ": " + note);
    part.values = std::move(one.values);
  }
  for (const Sum& sum : sums_) {
    double total = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) total += parts_[k].values.at(sum[k]);
    report.values.push_back(total);
  }
  watch(window, motion, report);
  return report;
}

/// Checked every tenth window. The points of bodies that touch are a spacing apart.
void SolidGroup::watch(const Window& window, const InterfaceMotion& motion, Report& report) {
  constexpr std::uint64_t interval = 10;  // windows
  constexpr double near = 0.5;            // spacings
  if (window.index % interval != 0 || (met_ && *met_ != window.index)) return;
  const Field places = places_ + motion.displacement;
  const auto overlap = find_overlap(places, structure_, near * spacing_);
  if (!overlap) return;
  met_ = window.index;
  const auto name = [&](Eigen::Index p) {
    return parts_[static_cast<std::size_t>(structure_[static_cast<std::size_t>(p)])].name;
  };
  std::vector<std::string> place;
  for (const double x : places.col(overlap->first)) place.push_back(fmt::format("{:.4g}", x));
  report.notes.push_back(fmt::format(
      "warning: {} and {} overlap at ({}) m at t = {:.4g} s: structures do not feel each other's "
      "contact; bodies that can collide belong into one structure",
      name(overlap->first), name(overlap->second), fmt::join(place, ", "), window.start + window.size));
}

void SolidGroup::give(const InterfaceLoad& load, Part& part) const {
  part.load.force = load.force(Eigen::all, part.points);
  part.load.pressure = load.pressure(part.points);
}

void SolidGroup::take(const Part& part, InterfaceMotion& motion) const {
  motion.displacement(Eigen::all, part.points) = part.motion.displacement;
  motion.velocity(Eigen::all, part.points) = part.motion.velocity;
  motion.ramp_increment(Eigen::all, part.points) = part.motion.ramp_increment;
  motion.frequency = std::max(motion.frequency, part.motion.frequency);
  for (const Mode& mode : part.motion.modes) {
    motion.modes.push_back({.shape = Field::Zero(motion.velocity.rows(), motion.velocity.cols()),
                            .mobility = mode.mobility,
                            .load = mode.load});
    motion.modes.back().shape(Eigen::all, part.points) = mode.shape;
  }
}

std::string SolidGroup::save() {
  StateWriter state;
  for (const Part& part : parts_) state.put(with_name(part.name, [&] { return part.solid->save(); }));
  return state.take();
}

void SolidGroup::restore(const std::string& bytes) {
  StateReader state(bytes);
  for (const Part& part : parts_) {
    std::string saved;
    state.get(saved);
    with_name(part.name, [&] { part.solid->restore(saved); });
  }
  state.finish();
}

Snapshot SolidGroup::frame() {
  std::vector<Snapshot> frames;
  Snapshot all;
  for (const Part& part : parts_) {
    frames.push_back(with_name(part.name, [&] { return part.solid->frame(); }));
    for (const Array& array : frames.back())
      if (find(all, array) == nullptr)
        all.push_back(
            {.name = plain_name(array), .unit = array.unit, .components = array.components, .values = {}});
  }
  for (Array& joined : all) {
    for (const Snapshot& frame : frames) {
      const Array* array = find(frame, joined);
      if (array != nullptr)
        joined.values.insert(joined.values.end(), array->values.begin(), array->values.end());
      else if (!frame.empty())
        joined.values.resize(joined.values.size() +
                             particles_of(frame.front()) * static_cast<std::size_t>(joined.components));
    }
  }
  return all;
}

void SolidGroup::finalize() {
  for (const Part& part : parts_) with_name(part.name, [&] { part.solid->finalize(); });
}

}  // namespace cosurge
