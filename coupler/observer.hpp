// Who looks on while a run goes, and what is shown.
#pragma once

#include <string>
#include <vector>

#include "common/participant.hpp"

namespace cosurge {

/// A participant as progress, results and summary know it.
struct Member {
  std::string name;  ///< "fluid" or "solid"
  Identity identity;
  Setup setup;
};

/// What the participants said of a window, those that are there: fluid first.
using Reports = std::vector<Report>;

/// Progress line, results, or a watcher of one's own.
class Observer {
 public:
  virtual ~Observer() = default;
  /// After every window that stands: reports in the order of the members, then the coupler's own values by
  /// Coupler::columns().
  virtual void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) = 0;
  /// At every landing, and at the start: the particles of each member.
  virtual void frame(double /*time*/, const std::vector<Snapshot>& /*snapshots*/) {}
};

}  // namespace cosurge
