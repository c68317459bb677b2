// Floor and side walls of the tank, for contact with bodies.
#pragma once

#include <string>

#include "common/error.hpp"
#include "common/geometry/tank.hpp"

namespace cosurge::contact {

/// Planes that move with the tank. Side walls end at its open top: a vertex that has passed above it does not
/// touch them.
template <int dim>
class TankWalls {
 public:
  static constexpr int count = 2 * dim - 1;  ///< the floor first, then both sides of each other axis

  explicit TankWalls(const Tank<dim>& tank) : tank_(tank.box), motion_(tank.motion) {}

  /// Planes of the tank, from their initial positions.
  const Motion<dim>& motion() const { return motion_; }

  /// Distance of a point from the wall [m], negative beyond it, in the tank's initial position.
  double gap(int wall, const Vec<dim>& x) const {
    const int k = axis(wall);
    if (wall > 0 && x[dim - 1] > tank_.max[dim - 1]) return tank_.max[k] - tank_.min[k];
    return upper(wall) ? tank_.max[k] - x[k] : x[k] - tank_.min[k];
  }

  /// Unit normal into the tank at t = 0.
  Vec<dim> normal(int wall) const { return (upper(wall) ? -1 : 1) * Vec<dim>::Unit(axis(wall)); }

  std::string name(int wall) const {
    if (wall == 0) return "the floor of the tank";
    const int k = axis(wall);
    return fmt::format("the wall of the tank at {} = {:.6g} m", "xyz"[k],
                       upper(wall) ? tank_.max[k] : tank_.min[k]);
  }

 private:
  static int axis(int wall) { return wall == 0 ? dim - 1 : (wall - 1) / 2; }
  static bool upper(int wall) { return wall > 0 && wall % 2 == 0; }

  Box<dim> tank_;
  Motion<dim> motion_;
};

}  // namespace cosurge::contact
