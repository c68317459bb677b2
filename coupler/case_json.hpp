// A case as JSON.
#pragma once

#include <string>

#include "proto/case.pb.h"

namespace cosurge {

/// With all its defaults, and the names of the case file.
std::string as_json(const v1::Case& the_case);

}  // namespace cosurge
