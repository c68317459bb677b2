// The words of a command line.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// A word of a command line as it must be typed: in quotes where the shell would read it in another way.
std::string shell_word(const std::string& word);

/// The message for a word that is not one of the `commands`, with the nearest one; empty if it is one.
std::string unknown_command(const std::vector<std::string>& commands, const std::string& word);

}  // namespace cosurge
