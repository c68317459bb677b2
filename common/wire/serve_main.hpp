// A solver program around a participant.
#pragma once

#include <functional>
#include <memory>

#include "common/participant.hpp"

namespace cosurge {

/// The main function of a solver program: command line, threads, connection, and requests until the run is
/// over (docs/protocol.md). Errors go to stderr.
/// Returns 0 after a finalized run, 1 after an error, 2 for a wrong command line, 3 where the numbers failed.
int serve_main(int argc, char** argv, const std::function<std::unique_ptr<Participant>()>& make);

}  // namespace cosurge
