// Whether the sides of a polygon cross.
#pragma once

#include <string>
#include <vector>

#include "common/facet_tree.hpp"

namespace cosurge {

/// What is wrong with the sides of a polygon, in words: two that cross, or lie on each other; empty where
/// nothing is. Where it would take more than a second to say, since most of very many sides lie side by side,
/// it says that.
std::string crossing_sides(const std::vector<Facet<2>>& sides);

}  // namespace cosurge
