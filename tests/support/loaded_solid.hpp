// A solid participant under loads that a test chooses.
#pragma once

#include <cmath>

#include "common/error.hpp"
#include "solid_solver/solid_participant.hpp"
#include "tests/support/solid_cases.hpp"

namespace cosurge::test {

/// A participant, its surface, and the reports of its windows.
struct LoadedSolid {
  SolidParticipant solid;
  Interface interface;
  InterfaceMotion motion;
  InterfaceLoad load;
  Setup setup;
  std::uint64_t windows = 0;
  double time = 0;

  LoadedSolid(const v1::Case& c, const Interface& points)
      : interface(points), load(InterfaceLoad::zero(c.dimension(), points.points())) {
    setup = solid.initialize(c, interface, load, motion);
  }
  Report advance(double size) {
    Report report = solid.advance({.index = windows++, .start = time, .size = size}, load, motion);
    time += size;
    return report;
  }
  double value(const Report& report, const std::string& name) const {
    for (std::size_t k = 0; k < setup.columns.size(); ++k)
      if (setup.columns[k].name == name) return report.values.at(k);
    throw Error("no column " + name);
  }
};

/// A load that changes from window to window and from point to point.
inline Field load_of(int window, Eigen::Index points) {
  Field load(2, points);
  for (Eigen::Index p = 0; p < points; ++p)
    load.col(p) << 0.02 * std::sin(0.9 * window + 0.1 * static_cast<double>(p)),
        0.01 * std::cos(1.7 * window);
  return load;
}

}  // namespace cosurge::test
