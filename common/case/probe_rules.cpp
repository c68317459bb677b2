#include "common/case/probe_rules.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "common/case/probe_columns.hpp"
#include "common/case/probe_mount.hpp"
#include "common/case/snap_probes.hpp"
#include "common/error.hpp"
#include "common/geometry/shape.hpp"

namespace cosurge {
namespace {

bool in_the_tank(const v1::Box& tank, const v1::Probe& probe) {
  constexpr double rounding = 1e-9;  // m
  for (int k = 0; k < probe.position_size(); ++k)
    if (probe.position(k) < tank.min(k) - rounding || probe.position(k) > tank.max(k) + rounding)
      return false;
  return true;
}

/// A displacement needs a body; a load needs a body, an obstacle or a side of the tank; a pressure needs a
/// face or water.
void check_place(const v1::Case& c, const v1::Probe& probe, const std::string& key, CaseErrors& errors) {
  using On = ProbeMount::On;
  const ProbeMount mount = mount_of(c, probe);
  const bool of_load = probe.quantity() == v1::Probe::force || probe.quantity() == v1::Probe::moment;
  const auto refuse = [&](const std::string& where) {
    const std::string nearest = nearest_body(c, probe);
    errors.add(key + ".position", where + (nearest.empty() ? "" : "; " + nearest));
  };
  if (probe.quantity() == v1::Probe::displacement) {
    if (mount.on != On::body) refuse("must lie in or on a body");
  } else if (of_load) {
    if (mount.on == On::tank)
      refuse("must lie in or on a body or an obstacle, or on the floor or a side wall of fluid.tank");
  } else if (mount.on == On::tank && !in_the_tank(c.fluid().tank(), probe)) {
    errors.add(key + ".position", "must lie in fluid.tank or on a body");
  }
  if (probe.quantity() == v1::Probe::pressure && (mount.on == On::body || mount.on == On::obstacle)) {
    const std::string deep = too_deep(c, probe);
    if (!deep.empty()) errors.add(key + ".position", deep);
  }
}

/// Checks that no two probes have the same column, and that no probe's column is one of the standard ones.
void check_columns(const v1::Case& c, CaseErrors& errors) {
  std::map<std::string, int> taken;
  for (int i = 0; i < c.output().probe_size(); ++i) {
    const v1::Probe& probe = c.output().probe(i);
    const auto add = [&](const std::string& what) {
      errors.add(fmt::format("output.probe.{}.name", i), what);
    };
    for (const std::string& column : probe_columns(probe, c.dimension())) {
      if (is_own_column(probe_group(probe), column))
        add(fmt::format("\"{}\" needs the column {}, which the {} solver already writes: choose another name",
                        probe.name(), column, probe_group(probe)));
      const auto [first, is_new] = taken.emplace(column, i);
      if (!is_new && first->second != i && c.output().probe(first->second).name() != probe.name())
        add(fmt::format(
            "\"{}\" needs the column {}, which output.probe.{} (\"{}\") needs too: choose another name",
            probe.name(), column, first->second, c.output().probe(first->second).name()));
    }
  }
}

}  // namespace

void check_probes(const v1::Case& c, CaseErrors& errors) {
  std::set<std::string> names;
  for (int i = 0; i < c.output().probe_size(); ++i) {
    const v1::Probe& probe = c.output().probe(i);
    const std::string key = fmt::format("output.probe.{}", i);
    const bool plain =
        !probe.name().empty() && std::all_of(probe.name().begin(), probe.name().end(), [](char a) {
          return std::isalnum(static_cast<unsigned char>(a)) != 0 || a == '_';
        });
    if (!plain) errors.add(key + ".name", "must consist of letters, digits and _");
    if (!names.insert(probe.name()).second)
      errors.add(key + ".name", fmt::format("\"{}\" is taken", probe.name()));
    if (probe.quantity() != v1::Probe::displacement && !c.has_fluid())
      errors.add(key + ".quantity", "needs a fluid");
    else
      check_place(c, probe, key, errors);
  }
  check_columns(c, errors);
}

}  // namespace cosurge
