// Faces of bodies that water cannot reach, since a wall or another body is there.
#pragma once

#include "fluid_solver/bodies.hpp"
#include "fluid_solver/neighbors.hpp"

namespace cosurge::fluid {

/// Which faces are open to water, and where a film of water is left in gaps.
template <int dim>
class CoveredFaces {
 public:
  /// Share of each wet lattice face of each point that is open to water: 0 where the gap to a wall or to
  /// another body is a quarter of a spacing at most, 1 where it is half a spacing at least, linear between
  /// (no particle fits in). The gap is told by the particles of walls and bodies that are near along the
  /// face's normal. Where water was within r_e when the gap became narrower than a spacing, a film of it is
  /// left, and the faces stay open.
  /// @param place of each point among the particles
  std::vector<Openness<dim>> find(const Bodies<dim>& bodies, const Faces<dim>& faces,
                                  const std::vector<int>& place, const Particles<dim>& particles,
                                  const Neighbors<dim>& neighbors, double spacing);

  /// For each point, whether there is water or a film of water; the only state.
  const std::vector<char>& film() const { return film_; }
  std::vector<char>& film() { return film_; }

 private:
  std::vector<char> film_;
};

}  // namespace cosurge::fluid
