// What a probe of the water measures, and where.
#pragma once

#include <string>
#include <vector>

#include "common/geometry/probe_mount.hpp"
#include "common/vec.hpp"

namespace cosurge::fluid {

enum class Quantity {
  pressure,  ///< pressure in the water, or on a body, obstacle or wall
  level,     ///< height of the free surface on the vertical line through the point
  force,     ///< force of the water on the body, obstacle or side of the tank
  moment,    ///< moment of the same load about the point
};

/// A probe of the case, except displacement probes, which the solid solver reads.
template <int dim>
struct Probe {
  std::string name;
  Quantity quantity;
  Vec<dim> position;  ///< initial position [m]
  ProbeMount mount;   ///< what it moves with
  std::vector<std::string> columns;
};

}  // namespace cosurge::fluid
