// A case as JSON.
#pragma once

#include <string>

#include "proto/case.pb.h"

namespace cosurge {

/// The case with all defaults as JSON, with the names of the case file.
std::string as_json(const v1::Case& the_case);

}  // namespace cosurge
