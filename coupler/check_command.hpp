// cosurge check: validates a case and estimates its size.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// Validates a case, lays it out, computes its first windows, and prints the particles, windows, memory and
/// expected time on this machine. `picture`: file of a picture of the case; empty: none.
/// @throws Error for a case that cannot run, and for a picture that cannot be written.
void check_command(const std::string& case_path, const std::vector<std::string>& overrides,
                   const std::string& picture = "");

}  // namespace cosurge
