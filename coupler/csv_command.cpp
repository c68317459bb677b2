#include "coupler/csv_command.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>

#include "common/error.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/results.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

/// The columns that were asked for behind time and window.
std::vector<std::string> chosen(const std::vector<std::string>& all, const std::vector<std::string>& wanted) {
  if (wanted.empty()) return all;
  std::vector<std::string> names = {"time", "window"};
  for (const std::string& name : wanted) {
    require(std::find(all.begin(), all.end(), name) != all.end(), "no column {}; there are {}", name,
            fmt::join(all, ", "));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::string table_of(const std::vector<Series>& columns) {
  std::vector<std::string> cells;
  std::size_t rows = std::numeric_limits<std::size_t>::max();
  for (const Series& series : columns) {
    cells.push_back(series.unit.empty() || series.unit == "-"
                        ? series.name
                        : fmt::format("{} [{}]", series.name, series.unit));
    rows = std::min(rows, series.values.size());
  }
  std::string text = fmt::format("{}\n", fmt::join(cells, ","));
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t c = 0; c < columns.size(); ++c)
      text += fmt::format("{}{}", columns[c].values[row], c + 1 == columns.size() ? "\n" : ",");
  return text;
}

}  // namespace

void csv_command(const CsvOptions& options) {
  const Results results(options.results);
  require(options.out.empty() || !fs::exists(options.out), "{}: exists already; choose another --out",
          options.out);
  std::vector<Series> columns;
  for (const std::string& name : chosen(results.histories(), options.columns))
    columns.push_back(results.history(name));
  const std::string text = table_of(columns);
  if (options.out.empty())
    std::cout << text << std::flush;
  else
    replace_file(options.out, {text});
}

}  // namespace cosurge
