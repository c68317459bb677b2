// Where the water of a case is at the start.
#pragma once

#include "proto/case.pb.h"

namespace cosurge {

/// Height of the highest and the lowest water of the start [m], above the origin. The case must have water.
double highest_water(const v1::Case& the_case);
double lowest_water(const v1::Case& the_case);

/// Gravity and differences of its potential.
struct WaterHeads {
  double gravity;     ///< |g| [m/s2]
  double of_water;    ///< g times the height of the water of the start, along gravity [m2/s2]
  double above_tank;  ///< g times the height of the highest water above the lowest point of the tank [m2/s2],
                      ///< at least 0
};

/// The case must have water.
WaterHeads water_heads(const v1::Case& the_case);

}  // namespace cosurge
