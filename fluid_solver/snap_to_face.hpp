// The faces of bodies that water wets.
#pragma once

#include <string>

#include "common/participant.hpp"
#include "common/vec.hpp"

namespace cosurge::fluid {

/// The point on the wet faces of all bodies that is nearest to `position` [m]; faces are squares (lines) of
/// the lattice, half a spacing from the centre of their particle.
/// @throws Error naming the probe and the nearest face, if it is more than a spacing away or there
/// is no face.
template <int dim>
Vec<dim> snap_to_face(const std::string& probe, const Vec<dim>& position, const Interface& interface,
                      double spacing);

}  // namespace cosurge::fluid
