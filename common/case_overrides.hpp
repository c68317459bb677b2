// Values that the command line puts in the place of a case's.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace cosurge {

/// Applies "key.path=value": `value` is TOML, or a bare word, which is a string; list entries are addressed
/// by number ("output.probe.0.name"); tables are made where there are none.
/// @throws Error where `text` has another form, or the way leads through a value.
void apply_override(toml::table& root, const std::string& text);

}  // namespace cosurge
