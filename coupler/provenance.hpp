// Where the case of a run comes from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cosurge {

/// Where the case of a run was read, and how it was changed.
struct Provenance {
  std::string case_file;               ///< absolute path; empty: not known
  std::vector<std::string> overrides;  ///< "key=value" that replace values of the file
  std::vector<std::string> changes;    ///< changes at resumptions: "t = 0.5 s: time.end: 0.5, now 1"

  /// For a new run.
  static Provenance of_case(const std::string& path, const std::vector<std::string>& overrides);

  /// From the results of a run; missing values are empty.
  /// @throws Error where they cannot be read.
  static Provenance of_results(const std::filesystem::path& results);
};

}  // namespace cosurge
