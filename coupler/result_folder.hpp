// The folder that a run takes for its results.
#pragma once

#include <filesystem>
#include <string>

namespace cosurge {

/// The case's name, which is the name of the folder of its file, also for the paths "." and "..".
std::string case_name(const std::filesystem::path& case_path);

/// A folder that no other run has while this lives: a lock of the system (flock), which ends with the process
/// however that ends.
class ResultFolder {
 public:
  /// For a new run: `out` where it is given, which must not hold any results, else results/NAME, or
  /// results/NAME-2 and so on, the first that is not there. Runs that start together get different ones, or
  /// are refused.
  /// @throws Error when it cannot be made, or `out` is taken.
  ResultFolder(const std::filesystem::path& case_path, const std::filesystem::path& out);
  ~ResultFolder();

  /// For a resumed run: the folder of its results. @throws Error if there is none, or a run is using
  /// it.
  static ResultFolder of_a_run(const std::filesystem::path& folder);

  /// Whether a run is using it now.
  static bool in_use(const std::filesystem::path& folder);

  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit ResultFolder(const std::filesystem::path& existing);
  bool lock();

  std::filesystem::path path_;
  int locked_ = -1;  // the folder's file descriptor, whose lock ends with it
};

}  // namespace cosurge
