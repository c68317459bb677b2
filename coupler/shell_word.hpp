// Command lines that a user can repeat.
#pragma once

#include <string>

namespace cosurge {

/// A word of a command line as it must be typed: in quotes if a shell would interpret it otherwise.
std::string shell_word(const std::string& word);

}  // namespace cosurge
