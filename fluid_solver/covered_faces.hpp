// Faces of bodies that water cannot reach, since a wall or another body is there.
#pragma once

#include "fluid_solver/bodies.hpp"
#include "fluid_solver/neighbors.hpp"

namespace cosurge::fluid {

/// What is open to water of the wet lattice faces of each point: 0 where the gap to a wall or to another body
/// is a quarter of a spacing at most, 1 where it is half a spacing at least, linear between (no particle fits
/// in). The gap is told by the particles of walls and bodies that are near along the face's normal.
/// @param place of each point among the particles
template <int dim>
std::vector<Openness<dim>> open_faces(const Bodies<dim>& bodies, const Faces<dim>& faces,
                                      const std::vector<int>& place, const Particles<dim>& particles,
                                      const Neighbors<dim>& neighbors, double spacing);

}  // namespace cosurge::fluid
