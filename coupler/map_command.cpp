#include "coupler/map_command.hpp"

#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "common/case_file.hpp"
#include "common/error.hpp"
#include "common/solvers.hpp"
#include "common/threads.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/swing.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr const char* columns =
    "state,end,windows,iterations,unconverged,ratio,alternation,created,frequency,amplitude,peak,peak_time,"
    "seconds,reason";

struct Axis {
  std::string key;
  std::vector<std::string> values;
};

/// Parts between the characters `at` that are not within brackets or quotes: a vector is one value.
std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '[' || c == '{')) ++depth;
    if (!quoted && (c == ']' || c == '}')) --depth;
    if (c == at && depth == 0 && !quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

Axis read_axis(const std::string& text) {
  const auto equals = text.find('=');
  require(equals != std::string::npos && equals + 1 < text.size(), "--over {}: must be key=value,value,...",
          text);
  Axis axis{.key = text.substr(0, equals), .values = split(text.substr(equals + 1), ',')};
  for (const std::string& value : axis.values)
    require(split(value, '/').size() == split(axis.key, '/').size(), "--over {}: {} is not a value for {}",
            text, value, axis.key);
  return axis;
}

std::string file_name(const std::vector<std::string>& cell) {
  std::string name = fmt::format("{}", fmt::join(cell, "_"));
  std::replace(name.begin(), name.end(), '/', '+');
  return name;
}

/// Every combination of values, the last axis the fastest.
std::vector<std::vector<std::string>> cells(const std::vector<Axis>& axes) {
  std::vector<std::vector<std::string>> grid = {{}};
  for (const Axis& axis : axes) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& cell : grid)
      for (const std::string& value : axis.values) {
        longer.push_back(cell);
        longer.back().push_back(value);
      }
    grid = longer;
  }
  return grid;
}

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return '"' + text + '"';
}

/// The values of a cell as they stand in the table: in quotes where they hold commas.
std::string row_of(const std::vector<std::string>& cell) {
  std::vector<std::string> values;
  for (const std::string& value : cell)
    values.push_back(value.find(',') == std::string::npos ? value : quoted(value));
  return fmt::format("{}", fmt::join(values, ","));
}

/// Whether a cell was computed to some end: neither refused nor blown up.
bool has_run(const std::string& row) { return !row.starts_with("refused") && !row.starts_with("blown_up"); }

/// The row of a cell behind its values.
std::string run_cell(const MapOptions& options, const std::vector<std::string>& settings) {
  std::vector<std::string> overrides = options.overrides;
  overrides.insert(overrides.end(), settings.begin(), settings.end());
  set_threads(1);
  const auto fluid = make_fluid_solver();
  const auto solid = make_solid_solver();
  std::unique_ptr<Coupler> coupler;
  try {
    const v1::Case the_case = load_case(options.case_path, overrides);
    require(the_case.has_fluid() && the_case.has_solid(), "the case needs a [fluid] and a [solid]");
    coupler = std::make_unique<Coupler>(the_case, Participants{fluid.get(), solid.get()});
  } catch (const std::exception& error) {
    return "refused,0,0,0,0,0,0,0,0,0,0,0,0," + quoted(error.what());
  }
  Swing swing(*coupler);
  std::string reason;
  try {
    coupler->run({&swing}, [] { return false; });
  } catch (const std::exception& error) {
    reason = error.what();
  }
  const char* state = reason.empty() ? swing.judgement() : "blown_up";
  return fmt::format("{},{:.6g},{},{:.3f},{},{:.4g},{:.4g},{:.4g},{:.6g},{:.6g},{:.6g},{:.6g},{:.2f},{}",
                     state, swing.end(), swing.windows(), swing.iterations(), coupler->unconverged(),
                     swing.largest_ratio(), swing.alternation(), swing.created(), swing.frequency(),
                     swing.amplitude(), swing.peak(), swing.peak_time(), processor_seconds(), quoted(reason));
}

}  // namespace

int map_command(const MapOptions& options) {
  std::vector<Axis> axes;
  for (const std::string& text : options.over) axes.push_back(read_axis(text));
  std::vector<std::string> keys;
  for (const Axis& axis : axes) keys.push_back(axis.key);
  const std::string head = fmt::format("{},{}", fmt::join(keys, ","), columns);
  const auto grid = cells(axes);
  const fs::path parts = options.out + ".cells";  // a file each, so that an interrupted map goes on
  fs::create_directories(parts);
  const auto part = [&](std::size_t k) { return parts / file_name(grid[k]); };
  const int cores = options.cores > 0 ? options.cores : static_cast<int>(std::thread::hardware_concurrency());

  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  const auto wait_for_one = [&] {
    int status = 0;
    const pid_t pid = waitpid(-1, &status, 0);
    const std::size_t k = running.at(pid);
    running.erase(pid);
    if (status != 0)
      replace_file(part(k),
                   {fmt::format("blown_up,0,0,0,0,0,0,0,0,0,0,0,0,\"its process ended with {}\"", status)});
    std::ifstream file(part(k));
    std::string row;
    std::getline(file, row);
    fmt::print("{}: {}\n", fmt::join(grid[k], ", "), row.substr(0, 90));
    std::fflush(stdout);
  };
  while (next < grid.size() || !running.empty()) {
    if (next == grid.size() || static_cast<int>(running.size()) == cores) {
      wait_for_one();
      continue;
    }
    const std::size_t k = next++;
    if (fs::exists(part(k))) continue;
    const pid_t pid = fork();
    require(pid >= 0, "no process for a cell: {}", std::strerror(errno));
    if (pid > 0) {
      running[pid] = k;
      continue;
    }
    std::vector<std::string> settings;
    for (std::size_t a = 0; a < axes.size(); ++a) {
      const std::vector<std::string> keys_of_axis = split(axes[a].key, '/'), values = split(grid[k][a], '/');
      for (std::size_t n = 0; n < keys_of_axis.size(); ++n)
        settings.push_back(keys_of_axis[n] + "=" + values.at(n));
    }
    int status = 1;
    try {
      replace_file(part(k), {run_cell(options, settings)});
      status = 0;
    } catch (...) {
    }
    _exit(status);
  }
  std::string table = fmt::format("# {}\n{}\n", options.note, head);
  std::size_t failed = 0;
  for (std::size_t k = 0; k < grid.size(); ++k) {
    std::ifstream file(part(k));
    std::string row;
    std::getline(file, row);
    failed += has_run(row) ? 0 : 1;
    table += fmt::format("{},{}\n", row_of(grid[k]), row);
  }
  replace_file(options.out, {table});
  fs::remove_all(parts);
  if (failed == grid.size())
    fmt::print("every cell failed; the reasons are the last column of {}\n", options.out);
  return failed == grid.size() ? 1 : 0;
}

}  // namespace cosurge
