// Rules of prescribed motions.
#pragma once

#include "common/case/case_rules.hpp"

namespace cosurge {

/// Checks that the motions of tank, obstacles and holders of bodies are complete, and that the clamps and
/// supports of one body move together.
void check_motions(const v1::Case& c, CaseErrors& errors);

}  // namespace cosurge
