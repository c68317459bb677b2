// The folder of a run for files that are removed at its end.
#pragma once

#include <filesystem>

namespace cosurge {

/// A new folder for the sockets and connection files of one run, which no other user may enter; it is removed
/// with this object. Folders of this user's killed runs are removed first, because they hold keys. A system
/// lock (flock), which ends with its process, marks the folders in use.
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
