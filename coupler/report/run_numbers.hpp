// The numbers of a run for a report.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coupler/results.hpp"

namespace cosurge {

/// The histories of a run, cut to one length, and its summary.
struct RunRecord {
  std::vector<Series> histories;  ///< time and window first
  nlohmann::json summary;         ///< empty object if there is none (yet), or only an older one

  explicit RunRecord(const Results& results);
  RunRecord(std::vector<Series> all, nlohmann::json its_summary)
      : histories(std::move(all)), summary(std::move(its_summary)) {}

  std::size_t rows() const { return histories.front().values.size(); }
  const std::vector<double>& time() const { return histories.front().values; }
  const Series* find(const std::string& name) const;
  double last(const std::string& name) const;  ///< NaN if there is none
  double most(const std::string& name) const;  ///< largest; NaN if there is none
};

/// The summary.json of a run with this many windows; empty if there is none, or one of an earlier end.
nlohmann::json summary_of(const Results& results, std::size_t windows);

/// "finished", "interrupted" or "failed"; "unfinished" where there is no summary.
std::string state_of(const nlohmann::json& summary);

/// Values of every history except clocks: [{"name", "unit", "peak", "peak_time", "min", "min_time", "max",
/// "max_time", "last"}], in their order, probes of the case first. The peak is the value farthest from zero.
nlohmann::ordered_json extremes(const RunRecord& run, const v1::Case& the_case);

/// Integrals over time of loads and of pressures of probes, by the trapezoidal rule: [{"name", "unit",
/// "value"}].
nlohmann::ordered_json impulses(const RunRecord& run, const v1::Case& the_case);

/// Energies at the first and the last window, and the work at the interface: [{"name", "unit", "first",
/// "last", "change"}]. Sums are entries of their own.
nlohmann::ordered_json balance(const RunRecord& run);

/// Seconds of wall time by phase: [{"member", "phase", "seconds"}].
nlohmann::ordered_json phases(const RunRecord& run);

/// Whether the run can be relied on, in one line: {"level": "good", "doubt" or "bad", "text"}.
nlohmann::ordered_json verdict(const RunRecord& run, const v1::Case& the_case);

/// {"state": "finished", "interrupted", "failed" or "unfinished" (running, or killed), "reason",
/// "time", "end", "windows", "wall_seconds"}.
nlohmann::ordered_json status(const RunRecord& run, const v1::Case& the_case);

/// Whether the name is of a column of a probe of the case ("solid/tip_x").
bool of_probe(const std::string& name, const v1::Case& the_case);

}  // namespace cosurge
