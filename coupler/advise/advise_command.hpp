// cosurge advise: the numbers of a scene, and the settings that suit it.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// Prints the numbers of a case (docs/speed_accuracy.md, cosurge advise), whether each structural model and
/// each coupling scheme fits, a recommendation, warnings of coarse spacings, and its size on this machine.
/// @throws Error for a case that cannot run, or that has no fluid or no structure.
void advise_command(const std::string& case_path, const std::vector<std::string>& overrides);

}  // namespace cosurge
