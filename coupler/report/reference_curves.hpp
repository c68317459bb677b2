// Published and measured curves beside the histories of a run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "proto/case.pb.h"

namespace cosurge {

/// The tables reference/*.csv of a case folder whose columns belong to a history of the case: `t_s`, and
/// `ux_m`, `uy_m`, `uz_m` (of every displacement probe), or a probe's column with its unit (`tip_y_m`,
/// `P01_Pa`, `gauge_m`). Returns [{"column": "solid/tip_x", "name": "Walhorn 2005", "time": [], "values":
/// []}]; tables of other columns are left out, and tables with a line that is no pair of numbers are named
/// in "error" instead of having values.
nlohmann::ordered_json reference_curves(const std::filesystem::path& case_folder, const v1::Case& the_case);

}  // namespace cosurge
