// Rules for the regions that particles fill: the tank, water, obstacles, bodies.
#pragma once

#include "common/case/case_rules.hpp"

namespace cosurge {

/// Whether no region has more sites than a computer can hold. To be asked before any region is filled.
bool check_sizes(const v1::Case& the_case, CaseErrors& errors);

/// Water and obstacles lie in the tank (an obstacle that moves may come into it later) and hold at least one
/// particle each, which for water no obstacle and no body takes; clamps lie outside the tank, or in
/// obstacles. After check_sizes().
void check_filled(const v1::Case& the_case, CaseErrors& errors);

}  // namespace cosurge
