// A place where a body is near another object or touches it.
#pragma once

#include <array>

#include "common/vec.hpp"

namespace cosurge::contact {

/// A vertex of one boundary near a facet of another, or near a wall. The gap depends on the vertices of both
/// bodies: d gap / d x_j = weight_j normal. Prescribed motions add to its rate.
template <int dim>
struct Touch {
  static constexpr int most = dim + 1;

  int body;                      ///< the first body of the two, or the only one
  int other;                     ///< the other object, see Neighborhood::name
  double gap;                    ///< relative to the initial gap if that is negative [m]
  Vec<dim> normal;               ///< unit normal
  Vec<dim> place;                ///< position of the vertex [m]
  double area;                   ///< area of the vertex [m^(dim-1)]
  double share;                  ///< factor on the stiffness per area, because both sides of a contact press
  double prescribed_rate;        ///< d gap / dt by prescribed motions [m/s]
  std::array<int, most> vertex;  ///< vertices of the bodies, -1: none
  std::array<double, most> weight;
};

}  // namespace cosurge::contact
