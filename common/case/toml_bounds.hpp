// TOML that the parser can take: it would recurse without bound into keys of very many parts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cosurge {

constexpr std::size_t most_key_parts = 16;  ///< limit for dotted keys; case keys have up to 4

/// @throws Error "SOURCE:line: ..." where a key of `text` has more parts than that.
void require_short_keys(std::string_view text, const std::string& source);

/// @throws Error "SOURCE:line: ..." where `text` has a character beyond ASCII outside of quotes and comments:
/// TOML has none there, and toml++ is undefined for those from U+00A1 to U+0499.
void require_ascii(std::string_view text, const std::string& source);

}  // namespace cosurge
