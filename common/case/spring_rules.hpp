// Rules of the springs of rigid bodies.
#pragma once

#include "common/case/case_rules.hpp"

namespace cosurge {

/// Checks that the springs of the model `sprung` name motions that the scene has, each once, and of the three
/// rotations in space one or all; and that the pivot has the scene's dimension.
void check_springs(const v1::Case& c, CaseErrors& errors);

}  // namespace cosurge
