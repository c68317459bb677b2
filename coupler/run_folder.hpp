// The folder of a run for what must not outlive it.
#pragma once

#include <filesystem>

namespace cosurge {

/// A new folder for the sockets and connection files of one run, which nobody else may enter; it goes with
/// this object. Those of this user's runs that were killed are removed before, since they hold keys: a lock
/// of the system (flock), which ends with the process, tells them from those in use.
class RunFolder {
 public:
  /// @throws Error when it cannot be made.
  RunFolder();
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int locked_ = -1;  // its descriptor
};

}  // namespace cosurge
