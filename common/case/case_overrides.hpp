// Values in place of a case's, and a case as the tree that they are set in.
#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "common/case/toml.hpp"

namespace cosurge {

/// The values that are set in a message, as in a case file.
toml::table tree_of(const google::protobuf::Message& message);

/// Applies "key.path=value": `value` is TOML, or a bare word, which is a string; list entries are addressed
/// by number ("output.probe.0.name"); tables are made where there are none. The word none removes the key, so
/// that its default holds; "none" in quotes is a text.
/// @throws Error where `text` has another form, or the way leads through a value.
void apply_override(toml::table& root, const std::string& text);

}  // namespace cosurge
