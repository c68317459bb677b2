// What a probe of the water is fixed to.
#pragma once

namespace cosurge {

struct ProbeMount {
  enum class On {
    tank,      ///< the tank's frame: a gauge in the water
    face,      ///< the tank's floor or one of its side walls
    obstacle,  ///< in or on an obstacle
    body,      ///< in or on a body
  };
  On on = On::tank;
  int number = -1;     ///< the obstacle or body
  int axis = 0;        ///< `face`: the axis across it
  bool upper = false;  ///< `face`: whether it is that with the larger coordinate
};

}  // namespace cosurge
