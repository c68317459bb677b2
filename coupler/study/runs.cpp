#include "coupler/study/runs.hpp"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <thread>

#include "common/error.hpp"
#include "coupler/map_cell.hpp"
#include "coupler/run_command.hpp"
#include "coupler/say.hpp"
#include "coupler/summary.hpp"
#include "coupler/work_processes.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

/// Files of one run.
struct Place {
  MapCell row;  // "finished,12.3" or "failed,0,reason"
  fs::path results;
  fs::path log;
};

/// A name that a person can read; with a number where letters had to be replaced or left out.
std::string name_of(const PlannedRun& run) {
  const std::string settings = fmt::format("{}", fmt::join(run.settings, ","));
  std::string name = settings;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::strchr("=.,-+_", c) == nullptr) c = '_';
  constexpr std::size_t longest = 120;  // the name of a file may have 255 letters
  name = name.substr(0, longest);
  if (name != settings) name += fmt::format("~{:x}", std::hash<std::string>{}(settings));
  return run.start == 0 ? name : fmt::format("{},start={}", name, run.start);
}

/// A reason on one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// User time of this process and of those that it has waited for [s].
double user_seconds() {
  double seconds = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    seconds +=
        static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
  }
  return seconds;
}

/// Why the run in a folder did not finish.
std::string reason_in(const Place& place) {
  const auto summary = summary_in(place.results);
  const std::string reason = summary.is_object() ? summary.value("reason", "") : "";
  return reason.empty() ? "see " + place.log.string() : reason;
}

/// The whole run, in a process of its own: its processor time is that of the run.
void compute(const PlannedRun& run, const std::string& case_path, const Place& place) {
  place.row.write("", "");  // before its results are removed
  fs::remove_all(place.results);
  for (std::FILE* stream : {stdout, stderr})
    require(std::freopen(place.log.c_str(), stream == stdout ? "w" : "a", stream) != nullptr,
            "{}: cannot be written", place.log.string());
  int status = 1;
  try {
    RunOptions options;
    options.case_path = case_path;
    options.overrides = run.overrides;
    options.out = place.results.string();
    options.threads = 1;
    status = run_command(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return place.row.write("", fmt::format("failed,0,{}", one_line(error.what())));
  }
  std::fflush(stdout);
  constexpr int failed = 1;
  if (status == 0)
    place.row.write(MapCell::identity(run.the_case), fmt::format("finished,{:.3f}", user_seconds()));
  else if (status == failed)
    place.row.write("", fmt::format("failed,{:.3f},{}", user_seconds(), one_line(reason_in(place))));
  else
    throw Error("the run was interrupted");
}

FinishedRun read_row(const Place& place) {
  const std::string row = place.row.row();
  FinishedRun run;
  run.finished = row.starts_with("finished,");
  run.folder = place.results;
  const auto comma = row.find(',');
  if (comma == std::string::npos) return run;
  run.core_seconds = std::strtod(row.c_str() + comma + 1, nullptr);
  if (const auto next = row.find(',', comma + 1); next != std::string::npos)
    run.reason = row.substr(next + 1);
  return run;
}

}  // namespace

StudyRuns::StudyRuns(const fs::path& folder) : folder_(folder / "runs") {
  std::error_code none;
  require(!fs::exists(folder) || fs::is_directory(folder), "{}: is not a folder; choose another --out",
          folder.string());
  require(!fs::exists(folder) || fs::exists(folder_) || fs::is_empty(folder, none),
          "{}: holds other files; choose another --out", folder.string());
  fs::create_directories(folder_, none);
  locked_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  require(locked_ >= 0, "{}: cannot be made", folder_.string());
  // Processes of a killed command need a moment to end.
  constexpr int tries = 50;
  bool taken = true;
  for (int k = 0; k < tries && taken; ++k) {
    if (k > 0) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    taken = ::flock(locked_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  }
  if (taken) ::close(locked_);
  require(!taken, "{}: another command is running a case in this folder", folder.string());
}

StudyRuns::~StudyRuns() { ::close(locked_); }

void StudyRuns::remove() const { fs::remove_all(folder_); }

std::vector<FinishedRun> StudyRuns::run(const StudyPlan& plan, const std::string& case_path,
                                        int cores) const {
  std::vector<Place> places;
  for (const PlannedRun& run : plan.runs) {
    const std::string name = name_of(run);
    std::vector<std::string> words = run.settings;
    words.push_back(fmt::format("start={}", run.start));
    places.push_back(
        {.row = MapCell(folder_, words), .results = folder_ / name, .log = folder_ / (name + ".log")});
  }
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (!places[k].row.has(MapCell::identity(plan.runs[k].the_case)) ||
        !fs::exists(places[k].results / "results.h5"))
      left.push_back(k);
  say("{} runs, {} of them to do\n", places.size(), left.size());
  const auto work = [&](std::size_t n) { compute(plan.runs[left[n]], case_path, places[left[n]]); };
  std::size_t done = 0;
  const auto ended = [&](std::size_t n, const std::string& fault) {
    const Place& place = places[left[n]];
    if (!fault.empty()) place.row.write("", fmt::format("failed,0,{}; see {}", fault, place.log.string()));
    const FinishedRun run = read_row(place);
    say("{}/{} {}: {}\n", ++done, left.size(), place.results.filename().string(),
        run.finished ? fmt::format("{:.3g} core s", run.core_seconds) : "failed: " + run.reason);
  };
  in_processes(left.size(), cores, work, ended);
  std::vector<FinishedRun> runs;
  for (const Place& place : places) runs.push_back(read_row(place));
  return runs;
}

}  // namespace cosurge
