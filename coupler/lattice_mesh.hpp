// Cells between the particles of a structure, for pictures of its surface and its inside.
#pragma once

#include <cstdint>
#include <vector>

#include "common/participant.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// Cells, all of one kind, between particles or points of a solver.
struct Mesh {
  int corners = 1;              ///< 1: points; 4: quadrilaterals; 8: hexahedra
  std::vector<int> connection;  ///< numbers of particles, `corners` a cell, in the order of VTK

  std::uint64_t cells() const { return connection.size() / static_cast<std::uint64_t>(corners); }
};

/// A point at each particle.
Mesh points_mesh(std::size_t particles);

/// Quadrilaterals or hexahedra between 2^d particles of one body on neighbouring sites of the lattice. Points
/// where there are none: a solver of one's own may have other places.
/// @param position of the particles, undeformed: components values for each
Mesh lattice_mesh(const v1::Case& the_case, const Array& position);

}  // namespace cosurge
