// Faults of a solver that a user requests to test a run.
#pragma once

namespace cosurge {

enum class SolverFault {
  kill,    ///< its process is killed (SIGKILL)
  freeze,  ///< its process is stopped (SIGSTOP)
  delay,   ///< its next message arrives 5 s late
  corrupt  ///< every bit of its next message is inverted
};

}  // namespace cosurge
