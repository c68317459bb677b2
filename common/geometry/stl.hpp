// Triangles from STL files.
#pragma once

#include <filesystem>
#include <vector>

namespace cosurge {

/// Corners of the triangles, three coordinates per corner, three corners per triangle. Reads text files (in
/// either case, with leading blanks or byte order mark, with one or more solids of any name, and any text
/// after the last one) and binary files (with any header, and any bytes after the last triangle).
/// @throws Error naming the file, and the line in a text file, if it is truncated or is not an STL file.
std::vector<double> read_stl(const std::filesystem::path& file);

}  // namespace cosurge
