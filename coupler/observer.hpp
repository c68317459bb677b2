// Observers of a run, and what they are shown.
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

/// The reports of the participants on a window, the fluid's first.
using Reports = std::vector<Report>;

/// Progress line, results, or a watcher of one's own.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Called after every settled window: reports in the order of the members, then the coupler's own values in
  /// the order of Coupler::columns().
  virtual void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) = 0;
  /// Called at the start and at the time of every frame: the particles of each member.
  virtual void frame(double /*time*/, const std::vector<Snapshot>& /*snapshots*/) {}
};

}  // namespace cosurge
