// The words of a command line.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// The message for a word that is not one of the `commands`, with the nearest one; empty if it is one.
std::string unknown_command(const std::vector<std::string>& commands, const std::string& word);

}  // namespace cosurge
