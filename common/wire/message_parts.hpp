// How many parts a message has, before memory is taken for them.
#pragma once

#include <google/protobuf/descriptor.h>

#include <cstddef>
#include <string_view>

namespace cosurge {

/// Texts, messages and unknown fields of one message: each takes tens of bytes of memory for the two that it
/// may have on the wire.
constexpr std::size_t most_parts = 1'000'000;

/// @throws Error where a message of type `type` has more parts, is nested deeper than any of the protocol, or
/// is malformed.
void require_few_parts(std::string_view bytes, const google::protobuf::Descriptor& type);

}  // namespace cosurge
