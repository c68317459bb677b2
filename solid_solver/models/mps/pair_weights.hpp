// Weights of the pairs of a body of MPS particles.
#pragma once

#include <vector>

#include "solid_solver/models/particles/body_grid.hpp"
#include "solid_solver/models/particles/lanes.hpp"

namespace cosurge::mps {

/// One entry of `pairs` for each neighbour of the stencil, over the slots of the first particle; 0 where
/// there is no pair.
template <int dim>
struct PairWeights {
  struct Pair {
    particles::Slots spring;   ///< weight in spring forces [-] (S4)
    particles::Slots stretch;  ///< weight in the dilatation [-] (S3)
    particles::Slots reach;    ///< share of the way to the neighbour over which the pair extends [-]
  };
  std::vector<Pair> pairs;
  particles::Slots dilates;  ///< 1 or 0: whether the particle has a pressure of its own
  double bending;  ///< beta of (S38): stiffness of pairs against relative rotation, over that of their
                   ///< springs [m2]
};

/// The lattice's weights w for all pairs of particles (Amaro & Cheng).
template <int dim>
PairWeights<dim> lattice_weights(const particles::BodyGrid<dim>& grid,
                                 const particles::Stencil<dim>& stencil);

/// The weights nearest to the lattice's, by the sum of squares, with which every free particle has the second
/// moment of the lattice (S37), also at faces, edges and corners. Pairs with held particles end at the face
/// of the clamp.
template <int dim>
PairWeights<dim> whole_weights(const particles::BodyGrid<dim>& grid, const particles::Stencil<dim>& stencil);

}  // namespace cosurge::mps
