// The tank of the water, and the obstacles in it.
#pragma once

#include "common/geometry/motion.hpp"
#include "common/geometry/shape.hpp"

namespace cosurge {

/// Inner faces of floor and side walls at the start; open at the top, the last coordinate.
template <int dim>
struct Tank {
  Box<dim> box;
  Motion<dim> motion;
};

template <int dim>
struct Obstacle {
  Shape<dim> shape;  ///< at the start
  Motion<dim> motion;
  bool with_tank;  ///< the motion is the tank's
};

}  // namespace cosurge
