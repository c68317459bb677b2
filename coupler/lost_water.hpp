// Message about water that has left the tank.
#pragma once

#include <string>

#include "coupler/recorder.hpp"

namespace cosurge {

/// How much of the water a run has lost, and at which sides of the tank; empty where none is, or where the
/// fluid solver does not say.
std::string lost_water(const Recorder& recorder);

}  // namespace cosurge
