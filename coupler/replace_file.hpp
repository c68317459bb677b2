// Text files that readers see whole.
#pragma once

#include <filesystem>
#include <string>

namespace cosurge {

/// Writes beside `path` and renames: whoever opens `path`, at any time, gets the old text or the new.
/// @throws Error when it cannot be written.
void replace_file(const std::filesystem::path& path, const std::string& text);

}  // namespace cosurge
