// Whether the sides of a polygon cross.
#pragma once

#include <string>
#include <vector>

#include "common/geometry/facet_tree.hpp"

namespace cosurge {

/// Describes errors of the sides of a polygon: two that cross, or lie on each other; empty if there
/// are none. If the check would take more than a second, because most of very many sides are close to each
/// other, the message says so.
std::string crossing_sides(const std::vector<Facet<2>>& sides);

}  // namespace cosurge
