// Histories, packed for the page of a report.
#pragma once

#include <nlohmann/json.hpp>

#include "coupler/report/run_numbers.hpp"

namespace cosurge {

/// Tables of histories: [{"exact", "rows", "columns": [{"name", "unit"}], "data"}], of which the first column
/// is the time [s], in 64 bits, the others have 32. Up to 60000 rows histories of probes and loads are
/// complete ("exact"); of the others, and of longer ones, there are the least and the largest value of each
/// of 4096 parts of the run, where it has more rows than twice that. Clocks are left out. The rows before
/// `first` are left out.
nlohmann::ordered_json pack_histories(const RunRecord& run, const v1::Case& the_case, std::size_t first = 0);

}  // namespace cosurge
