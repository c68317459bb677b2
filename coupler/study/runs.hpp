// Runs the plan of a study and measures the cost of each run; an interrupted study can continue.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupler/study/plan.hpp"

namespace cosurge {

/// How one run of a plan went.
struct FinishedRun {
  bool finished = false;         ///< it reached the end of its case
  double core_seconds = 0;       ///< user time of its processes: coupler and solvers
  std::string reason;            ///< why it did not finish
  std::filesystem::path folder;  ///< folder of its results
};

/// The runs of a study in its folder: runs/NAME are the results of one, runs/NAME.row its cost, runs/NAME.log
/// what it printed. NAME is made from the settings.
class StudyRuns {
 public:
  /// Locks the folder, and creates it if it does not exist.
  /// @throws Error where it is in use, or is not empty and holds no study.
  explicit StudyRuns(const std::filesystem::path& folder);
  ~StudyRuns();
  StudyRuns(const StudyRuns&) = delete;
  StudyRuns& operator=(const StudyRuns&) = delete;

  /// Runs everything that has not finished yet, `cores` runs at a time with one thread per solver. Finished
  /// runs of the same case by the same build are reused; failed and incomplete runs start again.
  std::vector<FinishedRun> run(const StudyPlan& plan, const std::string& case_path, int cores) const;

  /// Removes the results, rows and logs of all runs.
  void remove() const;

 private:
  std::filesystem::path folder_;
  int locked_ = -1;  // descriptor of the folder
};

}  // namespace cosurge
