#include "coupler/status_command.hpp"

#include <chrono>
#include <nlohmann/json.hpp>

#include "common/error.hpp"
#include "coupler/checkpoint.hpp"
#include "coupler/progress/progress_line.hpp"
#include "coupler/result_folder.hpp"
#include "coupler/summary.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

double seconds_between(fs::file_time_type first, fs::file_time_type second) {
  return std::chrono::duration<double>(second - first).count();
}

/// How the run has ended, by its summary and the lock of its folder.
std::string state_of(const fs::path& folder) {
  if (ResultFolder::in_use(folder)) return "running";
  const auto summary = summary_in(folder);
  if (!summary.is_object()) return "killed";
  const std::string reason = summary.value("reason", "");
  return summary.value("status", "unknown") + (reason.empty() ? "" : ": " + reason);
}

/// Speed from the time between the last two frames.
std::string speed_of(const fs::path& folder, const Checkpoint& last) {
  const fs::path path = folder / Checkpoint::name, before_path = folder / Checkpoint::name_before;
  if (!fs::exists(before_path)) return "";
  const double computed = last.time - Checkpoint::read_file(before_path).time;
  const double passed = seconds_between(fs::last_write_time(before_path), fs::last_write_time(path));
  if (computed <= 0 || passed <= 0) return "";
  const double rate = computed / passed;
  const double since = seconds_between(fs::last_write_time(path), fs::file_time_type::clock::now());
  const double left = std::max(0.0, (last.the_case.time().end() - last.time) / rate - since);
  return fmt::format("  {:.3g} s of simulated time per hour; about {} left; last frame {} ago\n", 3600 * rate,
                     clock_text(left), clock_text(since));
}

}  // namespace

std::string status_of(const fs::path& folder) {
  const bool there = fs::exists(folder / Recorder::results_name) || fs::exists(folder / "summary.json");
  require(there, "{}: contains no run", folder.string());
  const std::string state = state_of(folder);
  const bool running = state == "running";
  const std::string advice =
      running || state.starts_with("finished") ? "" : fmt::format("  cosurge resume {}\n", folder.string());
  if (!fs::exists(folder / Checkpoint::name)) return fmt::format("{}, before its first frame\n", state);
  const Checkpoint last = Checkpoint::read_file(folder / Checkpoint::name);
  const double end = last.the_case.time().end();
  return fmt::format(
      "{}\n  {}\n  t = {:.6g} of {:g} s ({:.0f} %) at the last frame, {} windows, {} frames\n{}{}",
      last.the_case.title(), state, last.time, end, 100 * last.time / end, last.windows, last.frames,
      running ? speed_of(folder, last) : "", advice);
}

}  // namespace cosurge
