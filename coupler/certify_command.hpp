// cosurge certify: whether a solver program keeps the protocol (docs/protocol.md).
#pragma once

#include <string>
#include <vector>

#include "common/participant.hpp"

namespace cosurge {

/// Options of cosurge certify.
struct CertifyOptions {
  std::vector<std::string> command;    ///< the program and its arguments; --connect and --threads are added
  std::vector<std::string> overrides;  ///< changes to the scene's case: solid.model=fem
  Role role = Role::solid;
  double patience = 30;  ///< longest wait for an answer [s]
};

/// Starts the program repeatedly with correct and incorrect runs, and prints one line per check. A solid gets
/// the points of a plate of 12 mm x 80 mm; a fluid creates its own points in a small dam break. Returns 0 if
/// all checks pass, 1 otherwise.
int certify_command(const CertifyOptions& options);

}  // namespace cosurge
