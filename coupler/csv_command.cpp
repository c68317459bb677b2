#include "coupler/csv_command.hpp"

#include <H5Cpp.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>

#include "common/error.hpp"
#include "coupler/recorder.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/result_file.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

struct Series {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

Series read_series(const H5::Group& histories, const std::string& name) {
  const H5::DataSet dataset = histories.openDataSet(name);
  const std::vector<hsize_t> size = extent(dataset);
  return {.name = name,
          .unit = dataset.attrExists("unit") ? text_of(dataset.openAttribute("unit")) : "",
          .values = first_rows(dataset, size.empty() ? 0 : size[0])};
}

/// "time", "window", "coupling/force_x", ...: the two first, then by group and name.
std::vector<std::string> names_in(const H5::Group& histories) {
  std::vector<std::string> names;
  for (hsize_t k = 0; k < histories.getNumObjs(); ++k) {
    const std::string group = histories.getObjnameByIdx(k);
    if (histories.childObjType(group) != H5O_TYPE_GROUP) continue;
    const H5::Group inner = histories.openGroup(group);
    for (hsize_t j = 0; j < inner.getNumObjs(); ++j) names.push_back(group + "/" + inner.getObjnameByIdx(j));
  }
  names.insert(names.begin(), {"time", "window"});
  return names;
}

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

std::string read_table_of(const fs::path& file, const std::vector<std::string>& wanted) {
  H5::Exception::dontPrint();
  H5::FileAccPropList access;
  H5Pset_file_locking(access.getId(), false, true);  // the run may go on
  try {
    const H5::H5File results(file.string(), H5F_ACC_RDONLY, H5::FileCreatPropList::DEFAULT, access);
    const H5::Group histories = results.openGroup("/history");
    std::vector<Series> columns;
    for (const std::string& name : chosen(names_in(histories), wanted))
      columns.push_back(read_series(histories, name));
    return table_of(columns);
  } catch (const H5::Exception& error) {
    throw Error(fmt::format("{}: cannot be read as results: {}", file.string(), error.getDetailMsg()));
  }
}

}  // namespace

void csv_command(const CsvOptions& options) {
  fs::path file = options.results;
  if (fs::is_directory(file)) file /= Recorder::results_name;
  require(fs::is_regular_file(file), "{}: no results there", file.string());
  require(options.out.empty() || !fs::exists(options.out), "{}: exists already; choose another --out",
          options.out);
  const std::string text = read_table_of(file, options.columns);
  if (options.out.empty())
    std::cout << text << std::flush;
  else
    replace_file(options.out, {text});
}

}  // namespace cosurge
