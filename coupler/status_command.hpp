// cosurge status: how far a run is, from its folder alone.
#pragma once

#include <filesystem>
#include <string>

namespace cosurge {

/// What there is to say of the run in a folder, on some lines: whether it goes on; the time reached at the
/// last frame, of which end; the speed between the last two frames, and the time left at it [h:mm:ss]; how to
/// go on with a run that has ended too early. Changes nothing.
/// @throws Error where no run is there.
std::string status_of(const std::filesystem::path& folder);

}  // namespace cosurge
