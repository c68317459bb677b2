// The folder that a run takes for its results.
#pragma once

#include <filesystem>
#include <string>

namespace cosurge {

/// The case's name: that of the folder its file is in, also where the path is "." or "..".
std::string case_name(const std::filesystem::path& case_path);

/// Makes a folder that no other run has: `out` where it is given, which must not hold any results or be in
/// use, else results/NAME, or results/NAME-2 and so on. Runs that start together get different ones.
/// @throws Error when it cannot be made, or `out` is taken.
std::filesystem::path take_folder(const std::filesystem::path& case_path, const std::filesystem::path& out);

}  // namespace cosurge
