// cosurge converge: the spacing that an accuracy needs, or that a budget allows.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

struct ConvergeOptions {
  std::string case_path;
  std::vector<std::string> overrides;   ///< "key.path=value"
  std::vector<std::string> quantities;  ///< as in a study, but rms, which needs a true history
  std::string accuracy;                 ///< "2%" or "0.02"; empty: none
  std::string budget;                   ///< core time of one run: "90s", "10min", "2h"; empty: none
  std::string out;                      ///< folder
  std::string note;                     ///< the command
};

/// Runs the case at two or three coarse spacings (SpacingRuns), twice each (the second time with gravity
/// changed by 1e-6), fits a line to each quantity and a power to the cost, prints what a run at a finer
/// spacing is expected to have of both, and runs the case at the coarsest spacing with the wanted accuracy,
/// or at the finest within the budget. Afterwards it prints what became of the prediction. Writes
/// converge.csv; the results of all runs stay in the folder. Returns 0, or 1 where a run failed or the wanted
/// accuracy was not reached.
/// @throws Error with all that is wrong with the options, before the first run.
int converge_command(const ConvergeOptions& options);

}  // namespace cosurge
