// A case before its run as a PNG.
#pragma once

#include <filesystem>

#include "coupler/report/frame_source.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// Draws tank, water, obstacles, bodies, clamps, supports and probes with their names, moving walls at their
/// extremes, and what outlines become on the lattice. Where the bodies are small in the scene, a second
/// panel shows them larger. `fluid` and `solid` have one frame, the start; sources without arrays where the
/// case has no such solver.
/// @throws Error where the file cannot be written.
void draw_case(const std::filesystem::path& file, const v1::Case& the_case, const FrameSource& fluid,
               const FrameSource& solid);

}  // namespace cosurge
