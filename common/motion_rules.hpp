// Rules of prescribed motions.
#pragma once

#include "common/case_rules.hpp"

namespace cosurge {

/// That motions of the tank, of obstacles and of what holds bodies are complete, and that a body is held by
/// what moves as one.
void check_motions(const v1::Case& c, CaseErrors& errors);

}  // namespace cosurge
