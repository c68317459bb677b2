// The moving picture of a report: which particles and frames it shows, and the frames.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "coupler/report/packed_frames.hpp"

namespace cosurge {

/// The displayed part of the frames of a run, within the size of the page.
struct SceneChoice {
  std::vector<Cast> casts;         ///< fluid, solid
  std::size_t every_frame = 1;     ///< one frame in this many is shown
  std::size_t every_particle = 1;  ///< the same of the water's particles
  std::size_t water = 0;           ///< particles of it in the frames
};

/// Chooses: all of the structure; of the fluid's particles the water, and walls: in two dimensions all, in
/// three those inside the tank (obstacles). Where packed frames would take more than `megabytes` (as
/// estimated), first frames are left out, down to a hundred, then particles of water.
SceneChoice choose(const v1::Case& the_case, const FrameSource& fluid, const FrameSource& solid,
                   std::size_t frames, double megabytes);

/// Chunks of frames (pack_frames()) of the numbers [first, last) that are multiples of every_frame. Each has
/// the number of its first shown frame, counted in shown frames, as "first".
nlohmann::ordered_json chunks(const SceneChoice& choice, const FrameSource& fluid, const FrameSource& solid,
                              std::size_t first, std::size_t last);

}  // namespace cosurge
