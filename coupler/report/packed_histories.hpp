// Histories, packed for the page of a report.
#pragma once

#include <nlohmann/json.hpp>

#include "coupler/report/run_numbers.hpp"

namespace cosurge {

/// Tables of histories: [{"exact", "rows", "columns": [{"name", "unit"}], "data"}]. The first column is
/// the time [s] in 64 bits; the others have 32 bits. Histories of probes and loads with up to 60000 rows are
/// complete ("exact"). Others with more than 8192 rows are reduced to the smallest and the largest value in
/// each of 4096 parts of the run. Clocks and the rows before `first` are left out.
nlohmann::ordered_json pack_histories(const RunRecord& run, const v1::Case& the_case, std::size_t first = 0);

}  // namespace cosurge
