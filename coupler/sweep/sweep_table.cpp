#include "coupler/sweep/sweep_table.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "coupler/case_grid.hpp"

namespace cosurge {
namespace {

using Cells = std::vector<std::string>;

std::string number(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

Cells head_of(const SweepTable& table) {
  Cells cells = table.keys;
  cells.insert(cells.end(), {"state", "core_seconds"});
  cells.insert(cells.end(), table.quantities.begin(), table.quantities.end());
  cells.emplace_back("reason");
  return cells;
}

Cells cells_of(const SweepRow& row) {
  Cells cells = row.values;
  cells.insert(cells.end(), {row.finished ? "finished" : "failed", fmt::format("{:.3f}", row.core_seconds)});
  for (const double value : row.quantities) cells.push_back(number(value));
  cells.push_back(row.reason);
  return cells;
}

/// `reason`: the last cell as it stands in the table.
std::string csv_line(Cells cells, const std::string& reason) {
  for (std::string& cell : cells) cell = cell_of(cell);
  cells.back() = reason;
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace

std::string csv_of(const SweepTable& table) {
  std::string text = fmt::format("# {}\n{}", table.note, csv_line(head_of(table), "reason"));
  for (const SweepRow& row : table.rows)
    text += csv_line(cells_of(row), row.reason.empty() ? "" : quoted_cell(row.reason));
  return text;
}

std::string text_of(const SweepTable& table) {
  std::vector<Cells> lines = {head_of(table)};
  for (const SweepRow& row : table.rows) lines.push_back(cells_of(row));
  std::string text;
  for (const Cells& line : lines) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      std::size_t width = 0;
      for (const Cells& other : lines) width = std::max(width, other[k].size());
      text += fmt::format("{:>{}}  ", line[k].empty() ? "-" : line[k], width);
    }
    text += line.back() + "\n";
  }
  return text;
}

}  // namespace cosurge
