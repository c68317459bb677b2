// The scene in which solver programs are certified.
#pragma once

#include <chrono>
#include <filesystem>

#include "common/participant.hpp"
#include "coupler/certify_command.hpp"
#include "proto/case.pb.h"

namespace cosurge::certify {

inline constexpr double size = 1e-4;               ///< window size [s]
inline constexpr std::chrono::seconds to_end{10};  ///< time limit for the program to end

/// A small dam break with a plate of 3 x 20 points, which stands clear of the water; `folder` gets its file.
v1::Case scene_for(const CertifyOptions& options, const std::filesystem::path& folder);

/// The lattice points of the plate, with the areas of its sides and its top.
Interface points_of_plate(const v1::Case& c);

}  // namespace cosurge::certify
