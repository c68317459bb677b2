// The end of a run: recorded data, the summary and the last messages.
#pragma once

#include <filesystem>

#include "coupler/coupler.hpp"
#include "coupler/recorder.hpp"
#include "coupler/summary.hpp"

namespace cosurge {

/// Largest deflection over length up to which the linear model `modal` is valid (docs/method_solid.md,
/// section 6).
constexpr double small_deflection = 0.05;

/// Whether a history is the deflection of a structure that this limit is for.
bool is_largest_deflection(const std::string& history);

/// Writes the recorded data and the summary, as far as the disk accepts them, and prints the result of the
/// run: first the remarks, then its end with the reason and, unless it is finished, how to resume it. If
/// something cannot be written, `outcome` gets the reason. `quiet`: for a finished run only the remarks are
/// printed.
/// @param checkpoint_time of the last checkpoint [s]
void conclude(const std::filesystem::path& folder, const Coupler& coupler, Recorder& recorder,
              double checkpoint_time, Outcome& outcome, bool quiet = false);

/// Whether the summary in `folder` says that the run is finished.
bool concluded(const std::filesystem::path& folder);

}  // namespace cosurge
