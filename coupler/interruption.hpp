// Signals that end a run early but in order.
#pragma once

#include <optional>
#include <string>

namespace cosurge {

/// From now on these signals are noted instead of ending the process: SIGINT, SIGTERM, SIGHUP (the terminal
/// was closed), SIGUSR1, SIGUSR2 and SIGXCPU (warnings of a batch system), and SIGPIPE (the output pipe was
/// closed). SIGHUP stays ignored if it was ignored before, as under nohup.
void note_interruptions();

/// Whether a signal that ends the run has been noted.
bool interrupted();

/// Whether the present window must be given up: a second after the first signal, at once after a second one.
bool overdue();

/// "signal 15 (Terminated)" of the last one that was noted.
std::optional<std::string> interruption();

}  // namespace cosurge
