// Case files: TOML against the closed schema of proto/case.proto.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// Reads a case: `path` is a folder with a case.toml, or the file. `overrides` are "key.path=value" with a
/// TOML value (a bare word is a string), applied before the checks; list entries are addressed by number
/// ("output.probe.0.name"). The word none removes a key ("time.window=none"), so that its default holds.
/// @throws Error with all errors at once, one line each: "file:line: key: error, allowed values".
v1::Case load_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// The same of the text of a case file, which errors call "case"; files that it names lie in `folder`.
v1::Case read_case(const std::string& text, const std::vector<std::string>& overrides = {},
                   const std::filesystem::path& folder = ".");

/// A case that was read before, with some of its values changed; files that it names are not read again.
/// @throws Error with all errors at once.
v1::Case change_case(const v1::Case& the_case, const std::vector<std::string>& overrides);

}  // namespace cosurge
