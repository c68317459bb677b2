// A load: force and moment.
#pragma once

#include <Eigen/Geometry>

#include "common/vec.hpp"

namespace cosurge::fluid {

/// Force and moment about a point, per metre of width in two dimensions.
template <int dim>
struct Load {
  Vec<dim> force = Vec<dim>::Zero();  ///< [N]
  Vec<3> moment = Vec<3>::Zero();     ///< about a point [N m]; in two dimensions the third component counts

  /// Adds a force that acts at `arm` from the point.
  void add(const Vec<dim>& arm, const Vec<dim>& by) {
    force += by;
    Vec<3> lever = Vec<3>::Zero(), in_space = Vec<3>::Zero();
    lever.head<dim>() = arm;
    in_space.head<dim>() = by;
    moment += lever.cross(in_space);
  }
};

}  // namespace cosurge::fluid
