// The boundary of a box as facets.
#pragma once

#include <vector>

#include "common/geometry/facet_tree.hpp"
#include "common/geometry/lattice.hpp"

namespace cosurge {

/// The four sides, ordered so that normal_of() (common/geometry/shape.hpp) points outwards.
std::vector<Facet<2>> facets_of(const Box<2>& box);

/// Two triangles for each of the six sides, ordered likewise.
std::vector<Facet<3>> facets_of(const Box<3>& box);

}  // namespace cosurge
