// cosurge report --video: a run as a video.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cosurge {

/// Writes the frames of one run as an MP4 of about ten seconds, and says where. Works during the run.
/// @throws Error, with all that is wrong, where there is more than one run, no results, no ffmpeg, or the
/// file exists or does not end in .mp4.
void video_command(const std::vector<std::string>& results, const std::filesystem::path& file);

}  // namespace cosurge
