// The progress of a run for a program: a JSON object a line.
#pragma once

#include <cstdio>
#include <filesystem>

#include "coupler/progress/progress_meter.hpp"
#include "coupler/summary.hpp"

namespace cosurge {

/// Takes over the standard output for its lines; everything else that the program prints there goes to the
/// standard error from then on. docs/results.md describes the lines.
class JsonLines {
 public:
  /// @throws Error where the standard output cannot be taken.
  JsonLines();
  ~JsonLines();
  JsonLines(const JsonLines&) = delete;
  JsonLines& operator=(const JsonLines&) = delete;

  void progress(const ProgressState& state, const std::vector<ProbeValue>& probes);
  void note(const std::string& note);

  /// The last line. `windows`: all that the run has computed.
  void end(const Outcome& outcome, double time, std::uint64_t windows, const std::filesystem::path& results);

 private:
  std::FILE* out_;
};

/// A line every second, and at the end of the case.
class JsonProgress : public Observer {
 public:
  /// `lines` must outlive the run; the others as the coupler has them.
  JsonProgress(const v1::Case& the_case, const std::vector<Member>& members,
               const std::vector<Column>& columns, JsonLines& lines)
      : meter_(the_case, members, columns), lines_(lines) {}

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override;

 private:
  ProgressMeter meter_;
  JsonLines& lines_;
};

}  // namespace cosurge
