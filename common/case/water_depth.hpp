// Where the water of a case is at the start.
#pragma once

#include "proto/case.pb.h"

namespace cosurge {

/// Height of the highest and the lowest water of the start [m], above the origin. The case must have water.
double highest_water(const v1::Case& the_case);
double lowest_water(const v1::Case& the_case);

}  // namespace cosurge
