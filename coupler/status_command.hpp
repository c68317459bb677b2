// cosurge status: how far a run is, from its folder alone.
#pragma once

#include <filesystem>
#include <string>

namespace cosurge {

/// Describes the run in a folder, on several lines: whether it is still running; the time of the last frame
/// and the end time; the speed between the last two frames, and the estimated time left [h:mm:ss]; how to
/// resume a run that has ended too early. Changes nothing.
/// @throws Error if there is no run in the folder.
std::string status_of(const std::filesystem::path& folder);

}  // namespace cosurge
