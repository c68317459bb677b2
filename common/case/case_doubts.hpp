// Warnings about values that are allowed but doubtful.
#pragma once

#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// Sentences on a checked case: numbers that look like those of other units, gravity that points out of the
/// tank, and what motion_doubts says. Empty where there is nothing to say.
std::vector<std::string> doubts(const v1::Case& c);

}  // namespace cosurge
