// The table of a sweep: for programs (CSV) and for the terminal.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// One run.
struct SweepRow {
  std::vector<std::string> values;  ///< values of the keys; empty text: the case's own value
  bool finished = false;
  double core_seconds = 0;
  std::vector<double> quantities;  ///< NaN where it did not finish
  std::string reason;              ///< why it did not finish
};

/// The table of a sweep.
struct SweepTable {
  std::string note;  ///< the command
  std::vector<std::string> keys;
  std::vector<std::string> quantities;  ///< quantities with their units: "peak(tip.x) [m]"
  std::vector<SweepRow> rows;
};

/// The table in CSV. First line: "# " and the command; then the keys, state (finished or failed),
/// core_seconds, the quantities, reason.
std::string csv_of(const SweepTable& table);

/// The table with aligned columns, without the command.
std::string text_of(const SweepTable& table);

}  // namespace cosurge
