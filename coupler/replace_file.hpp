// Text files that are replaced as a whole.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace cosurge {

/// Writes the concatenated `parts` to a new file beside `path` and renames it: a reader of `path` gets either
/// the old or the new text.
/// @throws Error when it cannot be written.
void replace_file(const std::filesystem::path& path, std::initializer_list<std::string_view> parts);

}  // namespace cosurge
