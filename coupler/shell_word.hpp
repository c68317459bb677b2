// Command lines that a user can repeat.
#pragma once

#include <string>

namespace cosurge {

/// A word of a command line as it must be typed: in quotes where a shell could read it in another way.
std::string shell_word(const std::string& word);

}  // namespace cosurge
