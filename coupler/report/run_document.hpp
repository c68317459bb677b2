// The data of a run for the page of a report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "coupler/report/scene.hpp"

namespace cosurge {

/// Options of the data of a page.
struct DocumentOptions {
  std::filesystem::path case_folder;  ///< folder of reference curves; empty: as the results say
  double megabytes = 4;               ///< approximate size of the frames of one run [MB]
};

/// A run as the page shows it, read anew at each call: also during a run.
class RunDocument {
 public:
  /// @throws Error where there are no results, or they cannot be read.
  RunDocument(const std::filesystem::path& results, const DocumentOptions& options);

  /// {"name", "title", "dimension", "status", "verdict", "facts", "case", "tables", "extremes", "impulses",
  /// "balance", "phases", "references", "scene"}; "scene" has the frames from the number `first_frame` of
  /// those that are shown on. Keys whose value is a table say its columns where it is made
  /// (coupler/report/run_numbers.hpp, case_table.hpp, outlines.hpp, scene.hpp).
  nlohmann::ordered_json read(std::size_t first_frame = 0);

  /// Whether the results have more data, or another state, than a page with `frames` frames, `windows`
  /// windows and the given state (status() in run_numbers.hpp). Reads little of the files.
  bool has_news(std::size_t frames, std::size_t windows, const std::string& state) const;

 private:
  nlohmann::ordered_json scene(const Results& results, const v1::Case& the_case, std::size_t first_frame);

  std::filesystem::path place_;
  DocumentOptions options_;
  std::optional<SceneChoice> choice_;  // made at the first frame: the page keeps its particles
};

/// {"made", "cosurge", "mode", "runs"}: all that a page gets.
/// @throws Error where the runs are not all of two or all of three dimensions
nlohmann::ordered_json page_document(const std::string& mode, nlohmann::ordered_json runs);

}  // namespace cosurge
