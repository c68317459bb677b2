// Text files that readers see whole.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace cosurge {

/// Writes `parts` one behind the other beside `path` and renames: whoever opens `path`, at any time, gets the
/// old text or the new.
/// @throws Error when it cannot be written.
void replace_file(const std::filesystem::path& path, std::initializer_list<std::string_view> parts);

}  // namespace cosurge
