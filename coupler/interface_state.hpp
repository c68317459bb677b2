// What the participants exchange.
#pragma once

#include "common/participant.hpp"

namespace cosurge {

/// The last motion and the last load of the interface points.
struct InterfaceState {
  InterfaceMotion motion;
  InterfaceLoad load;
};

}  // namespace cosurge
