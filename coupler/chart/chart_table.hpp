// The points of a chart as a table: for programs (CSV) and for the terminal.
#pragma once

#include <string>
#include <vector>

#include "coupler/study/plan.hpp"
#include "coupler/study/quantity.hpp"
#include "coupler/study/runs.hpp"

namespace cosurge {

/// One quantity of one setting, over its starts.
struct ChartValue {
  double value;            ///< mean
  double truth;            ///< true value; of rms: the rms of the true history
  double error;            ///< rms over the starts; NaN: unknown
  double lowest, highest;  ///< error of single starts
  bool front;              ///< no other setting is as cheap and as accurate
  double over_front;       ///< cost over that of the cheapest setting with no larger error
};

/// One setting of the plan.
struct ChartRow {
  std::vector<std::string> values;    ///< values of the keys
  std::vector<std::string> settings;  ///< "key=value"
  std::string state;        ///< "finished", "failed" or "truth": the run that the others are compared with
  double core_seconds = 0;  ///< mean over the starts
  std::string reason;       ///< why it failed
  std::vector<ChartValue> quantities;
};

/// The table of a chart.
struct ChartTable {
  std::string note;  ///< the command
  std::vector<std::string> keys;
  std::vector<std::string> quantities;
  std::vector<std::string> units;   ///< unit of each quantity
  std::vector<std::string> truths;  ///< truth of each quantity, in words
  int starts = 1;
  std::vector<ChartRow> rows;
};

/// Sets front and over_front of all finished rows.
void mark_front(ChartTable& table);

/// The table in CSV. First line: "# " and the command; then the keys, state, core_seconds and for each
/// quantity QUANTITY [unit], and its truth, error, lowest, highest, front (yes or no) and over_front; reason.
std::string csv_of(const ChartTable& table);

/// One block for each quantity, the cheapest setting first, those on the front marked by *.
std::string text_of(const ChartTable& table);

}  // namespace cosurge
