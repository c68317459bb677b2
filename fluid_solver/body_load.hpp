// The water's load on a body.
#pragma once

#include <utility>

#include "common/participant.hpp"
#include "fluid_solver/load.hpp"

namespace cosurge::fluid {

/// Sums the load of the water on one body, for force and moment probes.
template <int dim>
class BodyLoad {
 public:
  /// @param about the point of the undeformed body about which the moment is taken; it moves with the
  /// material there [m]
  BodyLoad(const Interface& interface, int body, const Vec<dim>& about, double spacing);

  Load<dim> read(const InterfaceMotion& motion, const InterfaceLoad& load) const;

 private:
  Vec<dim> about_;
  std::vector<Eigen::Index> point_;                      // indices of the body's points in the interface
  std::vector<Vec<dim>> place_;                          // positions of these points in the undeformed body
  std::vector<std::pair<Eigen::Index, double>> around_;  // interface points, weights: displacement of `about`
};

}  // namespace cosurge::fluid
