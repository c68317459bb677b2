// Measures the progress of a run.
#pragma once

#include <chrono>
#include <optional>

#include "coupler/observer.hpp"
#include "coupler/progress/progress_line.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// The value of one column of a probe.
struct ProbeValue {
  std::string name;  ///< name of its column in the results: "solid/tip_x"
  std::string unit;
  double value;
};

/// Counts windows and time, and finds the values of probes and coupling among the reports.
class ProgressMeter {
 public:
  /// `members` and `columns` as the coupler has them.
  ProgressMeter(const v1::Case& the_case, const std::vector<Member>& members,
                const std::vector<Column>& columns);

  /// Counts a window. Returns whether a state is due: `interval` seconds have passed since the last one, or
  /// the case has reached its end.
  bool count(const Window& window, double interval);

  /// The state after the window that was counted last.
  ProgressState state(const Reports& reports, const std::vector<double>& coupling);

  /// All columns of all probes, in the order of the case.
  std::vector<ProbeValue> probes(const Reports& reports) const;

 private:
  using Clock = std::chrono::steady_clock;

  /// Where a column stands among the reports.
  struct Place {
    std::size_t member;
    std::size_t column;
  };
  struct ProbePlace {
    std::string name;
    std::string unit;
    std::vector<std::string> columns;
    std::vector<Place> places;
  };

  static std::optional<Place> find(const std::vector<Member>& members, const std::string& member,
                                   const std::string& column);
  std::string main_probe(const Reports& reports) const;

  double end_;
  std::vector<Column> columns_;  // columns of the coupler's own values
  std::vector<ProbePlace> probes_;
  std::optional<Place> speed_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  std::optional<double> begin_;  // start of the first window of this process [s]: not 0 after a resumption
  Window last_;
  int unshown_ = 0;  // windows since the last state that was shown
  int told_ = 0;     // windows before it
};

}  // namespace cosurge
