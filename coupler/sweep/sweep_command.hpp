// cosurge sweep: a case over values of its keys.
#pragma once

#include "coupler/study/plan.hpp"

namespace cosurge {

/// Options of cosurge sweep.
struct SweepOptions : StudyOptions {
  bool keep = false;  ///< the results of the runs stay in the folder
};

/// Runs a case with every setting of a plan (StudyRuns), writes sweep.csv into the folder and prints it.
/// Without quantities the table has those of every probe: peak and time of peak, and of pressures, forces and
/// moments the impulse. The runs are removed once the table is complete, unless they are to be kept, or one
/// of them failed. Returns 0, or 1 where a run failed.
/// @throws Error with all that is wrong with options, plan and quantities, before the first run.
int sweep_command(const SweepOptions& options);

}  // namespace cosurge
