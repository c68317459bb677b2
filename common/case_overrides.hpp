// Values in place of a case's, and a case as the tree that they are set in.
#pragma once

#include <google/protobuf/message.h>
#include <toml++/toml.h>

#include <string>

namespace cosurge {

/// Sets one value, "key.path=value".
/// @throws Error where the text is none, or leads through a value or to no entry of a list.
void apply_override(toml::table& root, const std::string& text);

/// What is set in a message, as a case file has it.
toml::table tree_of(const google::protobuf::Message& message);

}  // namespace cosurge
