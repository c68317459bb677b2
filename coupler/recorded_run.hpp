// A run with recorded results, checkpoints and summary, and messages about its progress.
#pragma once

#include <filesystem>
#include <functional>

#include "coupler/fault.hpp"
#include "coupler/interruption.hpp"
#include "coupler/progress/json_progress.hpp"
#include "coupler/provenance.hpp"
#include "coupler/resumption.hpp"
#include "coupler/simulation.hpp"
#include "coupler/summary.hpp"

namespace cosurge {

/// Which messages a run prints.
enum class Telling {
  line,   ///< solvers, a line of progress, the end
  quiet,  ///< only warnings, and the end if the run did not finish
  json    ///< lines of JSON on the standard output, words on the standard error
};

/// A new case, or a resumption.
struct RecordedRun {
  v1::Case the_case;
  std::filesystem::path folder;  ///< folder of the results, which the caller has locked
  Provenance provenance;
  const Resumption* resumption = nullptr;
  Telling telling = Telling::line;
  JsonLines* lines = nullptr;                ///< output of lines, if telling is json
  std::vector<Fault> faults = {};            ///< solvers that are to fail
  std::function<bool()> stop = interrupted;  ///< asked after every window
};

/// Runs a simulation whose participants are chosen, and records results in the folder. If the computation
/// fails, the outcome has the reason. @throws Error if the run cannot start.
Outcome run_recorded(Simulation& simulation, const RecordedRun& job);

}  // namespace cosurge
