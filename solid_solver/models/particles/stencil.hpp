// The neighbours of a particle on the full lattice, and constants from them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/vec.hpp"

namespace cosurge::particles {

template <int dim>
using SiteIndex = Eigen::Matrix<long, dim, 1>;

/// Weight of a neighbour at distance r (Koshizuka & Oka 1996): w = r_e / r - 1 for r < r_e, else 0.
double weight(double r, double re);

/// A neighbour on the lattice.
template <int dim>
struct Neighbor {
  SiteIndex<dim> offset;
  Vec<dim> r0;    ///< to the neighbour in the reference configuration [m]
  double length;  ///< |r0| [m]
  double w;       ///< weight(length, r_e)
};

/// All neighbours within r_e, in the order of the lattice: the last coordinate slowest.
template <int dim>
struct Stencil {
  double spacing;  ///< l0 [m]
  std::vector<Neighbor<dim>> neighbors;
  double n0;  ///< sum of all weights; 6.5397 for r_e = 2.1 l0 in two dimensions
  int reach;  ///< largest component of an offset
};

/// @param re effective radius [l0]; sites at exactly this distance are no neighbours.
template <int dim>
Stencil<dim> full_stencil(double spacing, double re);

}  // namespace cosurge::particles
