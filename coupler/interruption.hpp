// Signals that end a run early but in order.
#pragma once

#include <optional>
#include <string>

namespace cosurge {

/// From now on SIGINT, SIGTERM, SIGHUP (the terminal is closed), SIGUSR1, SIGUSR2 and SIGXCPU (a queue's
/// warning) and SIGPIPE (whoever read the output is gone) are only noted. SIGHUP stays ignored where it was,
/// as nohup has it.
void note_interruptions();

bool interrupted();

/// Whether the present window must be given up: a second after the first signal, at once after a second one.
bool overdue();

/// "signal 15 (Terminated)" of the last one that was noted.
std::optional<std::string> interruption();

}  // namespace cosurge
