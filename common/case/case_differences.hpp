// Where two cases differ.
#pragma once

#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

struct Difference {
  std::string key;     ///< "output.probe.0.name"
  std::string first;   ///< value in the first case; "none" where it is missing
  std::string second;  ///< in the second
};

/// Keys whose values differ, in the order of the schema.
std::vector<Difference> differences(const v1::Case& first, const v1::Case& second);

}  // namespace cosurge
