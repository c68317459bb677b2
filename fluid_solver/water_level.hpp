// The height of the water's surface, without spray.
#pragma once

#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

/// The water as parts that hang together: particles that are less than 1.5 spacings from each other.
struct WaterParts {
  std::vector<std::int32_t> part;  ///< part of each particle; -1: not water
  std::vector<int> size;           ///< particles of each part
};

/// Finds the connected parts of the water, from its particles at the end of the last step.
template <int dim>
WaterParts connected_water(const Mps<dim>& mps, double spacing);

/// A line through the water.
template <int dim>
struct GaugeLine {
  Vec<dim> foot;  ///< its lower end [m]
  Vec<dim> up;    ///< unit vector
};

/// Height of the free surface above the foot of the line [m]. In the largest connected part of the water near
/// the line it is the highest point where that part fills half of the support not taken by walls and bodies.
/// Drops and sheets that have come off do not count, nor does a part of fewer particles than fill two
/// supports. 0 where there is no water.
template <int dim>
double level_over(const Mps<dim>& mps, const WaterParts& parts, const GaugeLine<dim>& line, double spacing);

}  // namespace cosurge::fluid
