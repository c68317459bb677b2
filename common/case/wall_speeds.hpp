// How fast prescribed motions drive the water.
#pragma once

#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// Largest speed of an obstacle or a prescribed body relative to the tank [m/s], at instants that divide the
/// run evenly; of the corners of the boxes around them. Empty if nothing moves.
std::vector<double> driven_speeds(const v1::Case& the_case);

}  // namespace cosurge
