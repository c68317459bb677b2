// Triangles of a surface as files have them, made whole: three coordinates a corner, three corners a
// triangle.
#pragma once

#include <array>
#include <vector>

#include "common/vec.hpp"

namespace cosurge {

using Triangle = std::array<Vec<3>, 3>;

/// Triangles whose corners that lie within 1e-6 of the size of all of each other are the same point, to the
/// bit; triangles that become a line are left out. Files keep six or seven digits of a coordinate.
std::vector<double> weld(const std::vector<double>& corners);

/// Whether every edge is passed as often in one sense as in the other: the surface is closed, and its
/// triangles are ordered the same way around.
bool is_oriented(const std::vector<Triangle>& triangles);

/// The same triangles, each ordered as its neighbours are: two of them on an edge that has no others pass it
/// in opposite senses. Closed parts that are not within another part are seen counterclockwise from outside.
/// Triangles that cannot be ordered so stay as they are.
std::vector<double> orient(const std::vector<double>& corners);

}  // namespace cosurge
