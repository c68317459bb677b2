// Particles, windows, memory and time of a case on this machine.
#pragma once

#include <vector>

#include "coupler/observer.hpp"
#include "coupler/simulation.hpp"

namespace cosurge {

/// Size and cost of a case, measured in its first windows.
struct MeasuredSize {
  std::vector<Member> members;    ///< the solvers with their particles and sub-steps
  long points = 0;                ///< number of interface points
  double windows = 0;             ///< to be expected until the end of the case
  double megabytes = 0;           ///< memory of this process [MB]
  double seconds_per_window = 0;  ///< mean of the windows after the third, of all if there are only three

  double seconds() const { return windows * seconds_per_window; }  ///< to be expected for the run
};

/// Sets the simulation up and computes its first windows: 13, or fewer if the run ends before or they take
/// longer than half a minute. The simulation must not have run before, and cannot continue.
MeasuredSize measure_size(Simulation& simulation);

/// Prints the size, a line for each number.
void say_size(const v1::Case& the_case, const MeasuredSize& size);

}  // namespace cosurge
