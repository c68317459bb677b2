// Warnings about prescribed motions that are allowed but probably not intended.
#pragma once

#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// Sentences on tables without a row within the run, walls that are much faster than a fall through the tank,
/// and obstacles that will come into the tank's floor or sides. Empty where there is nothing to say.
std::vector<std::string> motion_doubts(const v1::Case& c);

}  // namespace cosurge
