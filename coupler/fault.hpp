// cosurge run --fault: solvers that fail at a time of the simulation.
#pragma once

#include <string>
#include <vector>

#include "coupler/simulation.hpp"

namespace cosurge {

/// A solver, and when it fails in which way.
struct Fault {
  SolverFault kind;
  std::string solver;  ///< "fluid", "solid", or the name of one of several structures
  double time;         ///< [s] the solver fails at the first window that begins then or later
};

/// Faults from "KIND:SOLVER@TIME". `solvers`: names of all; `end`: of the run [s]; `elsewhere`: names of
/// solvers whose processes are not children of this one, so that they can be neither killed nor frozen.
/// @throws Error with all wrong texts.
std::vector<Fault> faults_of(const std::vector<std::string>& texts, const std::vector<std::string>& solvers,
                             double end, const std::vector<std::string>& elsewhere);

/// Call it between two windows: triggers the faults that are due, prints them, and removes them from the
/// list.
void let_fail(std::vector<Fault>& faults, Simulation& simulation);

}  // namespace cosurge
