// cosurge watch: the page of a run while it goes on.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// Options of cosurge watch.
struct WatchOptions {
  std::vector<std::string> results;  ///< folders of results, or their results.h5
  int port = 0;                      ///< 0: any that is free
  double megabytes = 20;             ///< approximate size of a page [MB]
};

/// Serves the page of `cosurge report` to this machine only, with what is new in the results, until a signal
/// ends it. The address has a secret word in it: other users of the machine cannot guess it. Returns the exit
/// status, 0.
/// @throws Error, with all that is wrong, where there are no results, or the port is taken.
int watch_command(const WatchOptions& options);

}  // namespace cosurge
