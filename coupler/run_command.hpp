// cosurge run: a coupled run from the case to the results.
#pragma once

#include <string>
#include <vector>

#include "coupler/recorded_run.hpp"

namespace cosurge {

/// Options of cosurge run and cosurge resume.
struct RunOptions {
  std::string case_path;
  std::vector<std::string> overrides;
  std::string out;          ///< folder of the results; empty: results/NAME, numbered where it is taken
  bool in_process = false;  ///< solvers as threads of this process
  std::vector<std::string>
      by_hand;        ///< "fluid", "solid=tcp://*:5555", "hull": solvers that somebody else starts
  std::string allow;  ///< file with the machines that may connect over TCP
  std::vector<std::string> faults;  ///< "kill:solid@0.05": solvers that fail at a time
  std::vector<std::string> solid;   ///< command of a program instead of solid_solver; of several structures
                                    ///< NAME=COMMAND
  int threads = 0;                  ///< threads of the fluid solver; 0: one per core
  double patience = 600;            ///< longest wait for a solver's answer [s]
  Telling telling = Telling::line;
};

/// Runs a case. Returns the exit status: 0 finished, 1 failed, 130 interrupted; the results are readable
/// after each.
/// @throws Error when the run cannot start: no results are written then, but the logs of the solvers stay.
int run_command(const RunOptions& options);

/// Resumes the run in the folder options.out from its checkpoint. The results are bit-identical to those of
/// an uninterrupted run, unless values are changed (options.overrides). Returns and throws like
/// run_command().
int resume_command(const RunOptions& options);

}  // namespace cosurge
