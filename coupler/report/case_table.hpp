// A case as a table of keys.
#pragma once

#include <nlohmann/json.hpp>

#include "proto/case.pb.h"

namespace cosurge {

/// All values of a case with their units, as its schema states them: [[key, value, unit]]. Keys are those of
/// --set: "fluid.spacing", "solid.body.0.box.min". Of long lists the first numbers and the count.
nlohmann::ordered_json case_table(const v1::Case& the_case);

}  // namespace cosurge
