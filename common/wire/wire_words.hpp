// Words that another program has sent.
#pragma once

#include <string>

namespace cosurge {

/// Text for a terminal: no more than `most` bytes, and '?' instead of control characters
/// (C0, DEL, and C1 as UTF-8 has it) other than the end of a line.
std::string printable(const std::string& words, std::size_t most = std::string::npos);

/// Checks that a name can be used in the results. `what`: "a column", for the message.
/// @throws Error where it is empty, too long, or has a slash or control characters.
void require_name(const std::string& name, const char* what);

}  // namespace cosurge
