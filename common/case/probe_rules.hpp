// Rules for the probes of a case.
#pragma once

#include "common/case/case_rules.hpp"

namespace cosurge {

/// Their names are plain and make columns of their own; they lie in or on a body or in the tank, and measure
/// what the scene has.
void check_probes(const v1::Case& the_case, CaseErrors& errors);

}  // namespace cosurge
