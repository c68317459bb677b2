// What moves by a prescribed motion.
#pragma once

#include <string>
#include <vector>

#include "common/geometry/motion.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// The corners of a box.
template <int dim>
std::vector<Vec<dim>> corners_of(const Box<dim>& box);

/// A prescribed motion, its key, and the box that moves by it.
template <int dim>
struct Mover {
  std::string key;
  const v1::WallMotion* prescribed;
  Motion<dim> motion;
  Box<dim> box;

  /// Largest speed of the corners of the box at time t [m/s].
  double speed(double t) const;
};

/// The tank, obstacles and bodies of a case that move. The case must outlive them.
template <int dim>
std::vector<Mover<dim>> movers_of(const v1::Case& the_case);

/// Largest speed of an obstacle or a prescribed body relative to the tank [m/s], at instants that divide the
/// run evenly. Empty if nothing but the tank moves.
std::vector<double> driven_speeds(const v1::Case& the_case);

}  // namespace cosurge
