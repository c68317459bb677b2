#include "coupler/map_command.hpp"

#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "common/threads.hpp"
#include "coupler/case_grid.hpp"
#include "coupler/map_cell.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/say.hpp"
#include "coupler/simulation.hpp"
#include "coupler/swing.hpp"
#include "coupler/work_processes.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr const char* columns =
    "state,end,windows,iterations,unconverged,ratio,alternation,created,frequency,amplitude,peak,peak_time,"
    "seconds,reason";

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The values of a cell as they stand in the table.
std::string row_of(const std::vector<std::string>& cell) {
  std::vector<std::string> values;
  for (const std::string& value : cell) values.push_back(cell_of(value));
  return fmt::format("{}", fmt::join(values, ","));
}

std::string refusal(const std::string& reason) {
  return "refused,0,0,0,0,0,0,0,0,0,0,0,0," + quoted_cell(reason);
}

/// Whether a cell was computed: it was neither rejected nor failed.
bool has_run(const std::string& row) { return !row.starts_with("refused") && !row.starts_with("blown_up"); }

/// The columns of a cell after the values of the keys.
std::string run_cell(const v1::Case& the_case) {
  set_threads(1);
  Simulation simulation(the_case);
  try {
    require(the_case.has_fluid() && the_case.has_solid(), "the case needs a [fluid] and a [solid]");
    simulation.begin();
  } catch (const std::exception& error) {
    return refusal(error.what());
  }
  Swing swing(simulation.coupler());
  simulation.observe(swing);
  std::string reason;
  try {
    simulation.run();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  const char* state = reason.empty() ? swing.judgement() : "blown_up";
  return fmt::format("{},{:.6g},{},{:.3f},{},{:.4g},{:.4g},{:.4g},{:.6g},{:.6g},{:.6g},{:.6g},{:.2f},{}",
                     state, swing.end(), swing.windows(), swing.iterations(),
                     simulation.coupler().unconverged(), swing.largest_ratio(), swing.alternation(),
                     swing.created(), swing.frequency(), swing.amplitude(), swing.peak(), swing.peak_time(),
                     processor_seconds(), quoted_cell(reason));
}

/// Runs a cell, unless the map has its row already.
void fill_cell(const MapOptions& options, const std::vector<std::string>& settings, const MapCell& cell) {
  std::vector<std::string> overrides = options.overrides;
  overrides.insert(overrides.end(), settings.begin(), settings.end());
  v1::Case the_case;
  try {
    the_case = load_case(options.case_path, overrides);
  } catch (const std::exception& error) {
    return cell.write("", refusal(error.what()));
  }
  const std::string identity = MapCell::identity(the_case);
  if (!cell.has(identity)) cell.write(identity, run_cell(the_case));
}

}  // namespace

int map_command(const MapOptions& options) {
  std::vector<Axis> axes;
  for (const std::string& text : options.over) axes.push_back(read_axis(text));
  std::vector<std::string> keys;
  for (const Axis& axis : axes) keys.push_back(axis.key);
  const std::string head = fmt::format("{},{}", fmt::join(keys, ","), columns);
  const auto grid = combinations(axes);
  const fs::path parts = options.out + ".cells";  // one file per cell, to continue an interrupted map
  fs::create_directories(parts);
  std::vector<MapCell> files;
  for (const auto& values : grid) files.emplace_back(parts, settings_of(axes, values));
  const auto say_row = [&](std::size_t k) {
    say("{}: {}\n", fmt::join(grid[k], ", "), files[k].row().substr(0, 90));
    std::fflush(stdout);
  };
  const auto fill = [&](std::size_t k) { fill_cell(options, settings_of(axes, grid[k]), files[k]); };
  const auto ended = [&](std::size_t k, const std::string& fault) {
    if (!fault.empty()) files[k].write("", "blown_up,0,0,0,0,0,0,0,0,0,0,0,0," + quoted_cell(fault));
    say_row(k);
  };
  const int cores = options.cores > 0 ? options.cores : static_cast<int>(std::thread::hardware_concurrency());
  in_processes(grid.size(), cores, fill, ended);
  std::string table = fmt::format("# {}\n{}\n", options.note, head);
  std::size_t failed = 0;
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const std::string row = files[k].row();
    failed += has_run(row) ? 0 : 1;
    table += fmt::format("{},{}\n", row_of(grid[k]), row);
  }
  replace_file(options.out, {table});
  fs::remove_all(parts);
  if (failed == grid.size())
    say("every cell failed; the reasons are in the last column of {}\n", options.out);
  return failed == grid.size() ? 1 : 0;
}

}  // namespace cosurge
