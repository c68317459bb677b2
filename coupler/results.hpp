// The results of a run, read from its results.h5.
#pragma once

#include <H5Cpp.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// One history: a value a window.
struct Series {
  std::string name;  ///< "fluid/front"
  std::string unit;
  std::vector<double> values;
};

/// An array of the frames.
struct FrameArray {
  std::string name;  ///< "pressure"
  std::string unit;
  std::size_t frames = 0;
  std::size_t particles = 0;
  int components = 1;
};

/// Reads results.h5, also while the run goes on and after a run was killed. A reader that meets the moment of
/// writing may find one array longer than another: callers take the shortest. All calls throw Error where the
/// file cannot be read.
class Results {
 public:
  /// The results.h5 at `place`, the file itself or its folder. @throws Error if there is none.
  static std::filesystem::path file_at(const std::filesystem::path& place);

  /// `place`: folder of the results, or the results.h5 in it.
  /// @throws Error where there are none, or where a later version of Cosurge has written them.
  explicit Results(const std::filesystem::path& place);

  const std::filesystem::path& file() const { return path_; }
  std::filesystem::path folder() const { return path_.parent_path(); }

  /// An attribute of the root; empty if there is none.
  std::string attribute(const std::string& name) const;

  /// The case with all its defaults, as the run ended.
  v1::Case the_case() const;

  /// "time", "window", then "coupling/force_x" and so on by group and name.
  std::vector<std::string> histories() const;
  Series history(const std::string& name) const;

  /// Instants of the frames [s].
  std::vector<double> frame_times() const;

  /// The arrays of "fluid" or "solid"; none where the run has no such solver, or no frame yet.
  std::vector<FrameArray> arrays(const std::string& member) const;

  /// Frame `k` of an array: components values for each particle, one particle after the other.
  std::vector<float> frame(const std::string& member, const FrameArray& array, std::size_t k) const;

 private:
  template <typename Action>
  auto attempt(const std::string& doing, Action action) const;

  std::filesystem::path path_;
  H5::H5File results_;
};

/// Calls `read` again for two seconds while it throws: a run that is just writing makes parts of its file
/// unreadable for a moment.
void read_patiently(const std::function<void()>& read);

}  // namespace cosurge
