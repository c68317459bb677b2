// Frames of a solver's particles, packed for the page of a report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coupler/report/frame_source.hpp"

namespace cosurge {

/// The particles of a solver that a report shows: the same ones in all frames.
struct Cast {
  std::string member;                   ///< "fluid"
  std::vector<std::size_t> particles;   ///< their numbers in the frames
  double finest = 0;                    ///< resolution of positions that suffices [m]; 0: that of 16 bits
  std::vector<std::string> quantities;  ///< names of arrays to colour by; "speed" is computed from "velocity"
};

/// Packs some frames so that they can be read without any others. Positions are 16-bit multiples of a
/// step from an origin; a quantity is the square of 8 bits between its smallest and largest value, so that
/// small values next to a peak stay visible. For each frame the page gets the difference of each coordinate
/// from its extrapolation from the two frames before (with the sign in the lowest bit), the kind, and the
/// quantities as differences from the frame before. Particles at a position that is not finite get the kind
/// 5, lost. Returns {"member", "particles", "origin", "step", "components", "kinds", "quantities": [{"name",
/// "unit", "min", "max"}], "frames", "data"}: data is packed() (coupler/report/packing.hpp).
nlohmann::ordered_json pack_frames(const FrameSource& source, const Cast& cast,
                                   const std::vector<std::size_t>& frames);

}  // namespace cosurge
