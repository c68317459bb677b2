// cosurge chart: what accuracy costs, over settings of a case.
#pragma once

#include "coupler/study/plan.hpp"

namespace cosurge {

/// Options of cosurge chart.
struct ChartOptions : StudyOptions {
  std::vector<std::string> truth;
};

/// Runs a case with every setting of a plan (StudyRuns), compares quantities of each with the truth, writes
/// chart.csv into the folder and prints the same with the Pareto front marked. The runs stay in the folder: a
/// chart of other quantities or another truth needs no new runs. Returns 0, or 1 where no run finished.
/// @throws Error with all errors in options, plan, quantities and truths, before the first run; and if the
/// run that is to be the truth failed.
int chart_command(const ChartOptions& options);

}  // namespace cosurge
