// The main function of a solver program.
#pragma once

#include <functional>
#include <memory>

#include "common/participant.hpp"

namespace cosurge {

/// The main function of a solver program: reads the command line, sets the threads, connects, and answers
/// requests until the run is over (docs/protocol.md). Errors go to stderr. Returns 0 after a finalized run, 1
/// after an error, 2 for a wrong command line, 3 after a numerical failure.
int serve_main(int argc, char** argv, const std::function<std::unique_ptr<Participant>()>& make);

}  // namespace cosurge
