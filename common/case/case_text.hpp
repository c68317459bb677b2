// A case file before its keys are looked at: text and TOML tree.
#pragma once

#include <filesystem>
#include <string>

#include "common/case/toml.hpp"

namespace cosurge {

/// @throws Error where the file cannot be read, or is too long for a case.
std::string case_text(const std::filesystem::path& file);

/// The tree of a text, which errors call `name`.
/// @throws Error "name:line: what is wrong".
toml::table case_tree(const std::string& text, const std::string& name);

/// A case that is written for a later schema may have keys that this program cannot know: said before all
/// else.
/// @throws Error where `schema` is newer than proto/case.proto.
void require_known_schema(const toml::table& root);

}  // namespace cosurge
