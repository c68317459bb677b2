// The files that a case names: outlines of shapes, and tables of motions.
#pragma once

#include <filesystem>

#include "common/case/case_rules.hpp"

namespace cosurge {

/// Reads every outline and table that the case names into the case, from files beside `folder`: tables as in
/// common/case/table.hpp, STL as in common/geometry/stl.hpp. Outlines are scaled, turned and moved; angles
/// are in rad thereafter. So a case is whole in itself from here on. Adds to `errors` what cannot be read,
/// with file and line.
void read_tables(v1::Case& the_case, const std::filesystem::path& folder, CaseErrors& errors);

}  // namespace cosurge
