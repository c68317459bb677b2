// The runs of a study: settings of a case, and perturbed starts.
#pragma once

#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// Common options of chart and sweep: a case, its settings, and the folder of the runs.
struct StudyOptions {
  std::string case_path;
  std::vector<std::string> overrides;  ///< "key.path=value" for every run
  std::vector<std::string> over;       ///< "key=a,b": directions of a grid, as in map
  std::string plan;                    ///< CSV: a key a column, a run a row; empty: none
  std::vector<std::string> quantities;
  int scatter = 0;   ///< number of perturbed starts of each run in addition to its own
  int cores = 1;     ///< runs at a time
  std::string out;   ///< folder
  std::string note;  ///< command that makes the table, its first line
};

/// One run: its settings in the plan, and the case with them.
struct PlannedRun {
  std::vector<std::string> values;     ///< values of the plan's keys; empty text: the case's own value
  std::vector<std::string> settings;   ///< "key=value" of these
  std::vector<std::string> overrides;  ///< everything that is set, also for the perturbed start
  int start = 0;                       ///< 0: the case's own; else number of the perturbed start
  v1::Case the_case;
};

/// All runs of a study.
struct StudyPlan {
  std::vector<std::string> keys;  ///< keys of the plan, the first columns of the table
  int starts = 1;                 ///< runs of the same settings, one after the other
  std::vector<PlannedRun> runs;
};

/// Every row of the plan with every cell of the grid, `scatter` + 1 starts each. Start k > 0 has gravity
/// times 1 + 1e-6 k: too little to change the solution by itself, but enough for the particles to move
/// differently.
/// @throws Error with all that is wrong in any run, and where two settings are the same case.
StudyPlan read_plan(const StudyOptions& options);

}  // namespace cosurge
