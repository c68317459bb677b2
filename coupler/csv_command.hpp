// cosurge csv: the histories of a run as a table for spreadsheets.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// Options of cosurge csv.
struct CsvOptions {
  std::string results;               ///< folder of the results, or its results.h5
  std::vector<std::string> columns;  ///< "fluid/front", "solid/tip_x"; empty: all
  std::string out;                   ///< the table; empty: standard output
};

/// Writes one row per window: the time, the window size and the histories, separated by commas, with a header
/// of names and units ("fluid/front [m]"). Numbers have full precision. Can be used during the run.
/// @throws Error where there are no results, no such column, or the table exists or cannot be written.
void csv_command(const CsvOptions& options);

}  // namespace cosurge
