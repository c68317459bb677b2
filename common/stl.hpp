// Triangles from STL files.
#pragma once

#include <filesystem>
#include <vector>

namespace cosurge {

/// Corners of the triangles, three coordinates each, three corners a triangle. Text (in capital or small
/// letters, with blanks or a byte order mark in front, of one or several solids with any names, whatever
/// follows the last one) or binary (whatever the header says and whatever follows the last triangle).
/// @throws Error naming the file, and the line of a text, when it is cut off or is no STL.
std::vector<double> read_stl(const std::filesystem::path& file);

}  // namespace cosurge
