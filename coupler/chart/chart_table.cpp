#include "coupler/chart/chart_table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupler/case_grid.hpp"
#include "coupler/chart/pareto.hpp"

namespace cosurge {
namespace {

/// A number of the table; empty where it is unknown.
std::string number(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

std::string head_of(const ChartTable& table) {
  std::vector<std::string> cells;
  for (const std::string& key : table.keys) cells.push_back(cell_of(key));
  cells.insert(cells.end(), {"state", "core_seconds"});
  for (std::size_t q = 0; q < table.quantities.size(); ++q) {
    const std::string& name = table.quantities[q];
    cells.push_back(cell_of(fmt::format("{} [{}]", name, table.units[q])));
    for (const char* what : {"truth", "error", "lowest", "highest", "front", "over_front"})
      cells.push_back(cell_of(fmt::format("{} {}", name, what)));
  }
  cells.emplace_back("reason");
  return fmt::format("{}", fmt::join(cells, ","));
}

/// All rows, the cheapest first and those that failed last.
std::vector<const ChartRow*> by_cost(const ChartTable& table) {
  std::vector<const ChartRow*> rows;
  for (const ChartRow& row : table.rows) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const ChartRow* a, const ChartRow* b) {
    const bool a_failed = a->state == "failed", b_failed = b->state == "failed";
    return a_failed != b_failed ? b_failed : a->core_seconds < b->core_seconds;
  });
  return rows;
}

std::string percent(const ChartValue& value) {
  const double share = 100 * value.error / std::abs(value.truth);
  return std::isfinite(share) ? fmt::format("{:.2g} %", share) : "";
}

std::string line_of(const ChartRow& row, const ChartValue& value, bool scattered) {
  const std::string settings = fmt::format("{}", fmt::join(row.settings, " "));
  constexpr std::size_t longest = 90;  // letters of a reason on the terminal; the CSV table has the whole
  if (row.state == "failed")
    return fmt::format("  {:>9}  {}: {}{}\n", "failed", settings, row.reason.substr(0, longest),
                       row.reason.size() > longest ? " ..." : "");
  if (row.state == "truth")
    return fmt::format("  {:>9.4g} {:>12.5g} {:>12}  {}\n", row.core_seconds, value.value, "the truth",
                       settings);
  const std::string scatter =
      scattered ? fmt::format(" ({:.2g} to {:.2g})", value.lowest, value.highest) : "";
  return fmt::format("{} {:>9.4g} {:>12.5g} {:>12.3g} {:>8} {:>7}  {}{}\n", value.front ? '*' : ' ',
                     row.core_seconds, value.value, value.error, percent(value),
                     std::isnan(value.over_front) ? "" : fmt::format("{:.2f}x", value.over_front), settings,
                     scatter);
}

}  // namespace

void mark_front(ChartTable& table) {
  for (std::size_t q = 0; q < table.quantities.size(); ++q) {
    std::vector<CostAndError> points;
    std::vector<ChartValue*> values;
    for (ChartRow& row : table.rows) {
      if (row.state != "finished") continue;
      points.push_back({.cost = row.core_seconds, .error = row.quantities[q].error});
      values.push_back(&row.quantities[q]);
    }
    const auto ratios = cost_over_front(points);
    const auto front = on_front(points);
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k]->front = front[k];
      values[k]->over_front = ratios[k];
    }
  }
}

std::string csv_of(const ChartTable& table) {
  std::string text = fmt::format("# {}\n{}\n", table.note, head_of(table));
  for (const ChartRow& row : table.rows) {
    std::vector<std::string> cells;
    for (const std::string& value : row.values) cells.push_back(cell_of(value));
    cells.insert(cells.end(), {row.state, fmt::format("{:.3f}", row.core_seconds)});
    for (const ChartValue& v : row.quantities)
      for (const std::string& cell :
           {number(v.value), number(v.truth), number(v.error), number(v.lowest), number(v.highest),
            std::string(v.front ? "yes" : "no"), number(v.over_front)})
        cells.push_back(cell);
    cells.push_back(row.reason.empty() ? "" : quoted_cell(row.reason));
    text += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return text;
}

std::string text_of(const ChartTable& table) {
  std::string text;
  const bool scattered = table.starts > 1;
  for (std::size_t q = 0; q < table.quantities.size(); ++q) {
    text += fmt::format("\n{} [{}], truth: {}\n", table.quantities[q], table.units[q], table.truths[q]);
    text += fmt::format("  {:>9} {:>12} {:>12} {:>8} {:>7}  settings{}\n", "core s", "value", "error", "",
                        "cost", scattered ? " (errors of single starts)" : "");
    for (const ChartRow* row : by_cost(table)) text += line_of(*row, row->quantities[q], scattered);
  }
  text +=
      "\n* on the front: no other run is as cheap and as accurate. cost: that of the run over that of the "
      "cheapest run with no larger error\n";
  return text;
}

}  // namespace cosurge
