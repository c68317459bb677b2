// Input of the solid solver: the structure and its surroundings.
#pragma once

#include <string>
#include <vector>

#include "common/geometry/tank.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// What bodies can touch besides each other.
template <int dim>
struct Surroundings {
  std::optional<Tank<dim>> tank;  ///< none without water
  std::vector<Obstacle<dim>> obstacles;
  double window;  ///< expected window [s]
};

/// How loads and motions are exchanged with the water.
struct Exchange {
  bool ramped;        ///< the load goes linearly from that of the last window to the new one
  bool end_velocity;  ///< the water gets the velocity at the end of a window, otherwise the mean over it
  int modes;          ///< number of the lowest modes of each body whose response to a load is sent; 0: none
};

/// A material point whose displacement is recorded.
template <int dim>
struct DisplacementProbe {
  std::string name;
  Vec<dim> position;  ///< undeformed [m]
  int body;
};

/// Everything that the solid solver needs of a case.
template <int dim>
struct Scene {
  Structure<dim> structure;
  Surroundings<dim> surroundings;
  Exchange exchange;
  std::vector<DisplacementProbe<dim>> probes;
  bool limits_windows;  ///< the solvers choose the windows
};

}  // namespace cosurge
