// cosurge selftest: a case with an exact answer, on the user's own machine.
#pragma once

namespace cosurge {

/// A column of water on a sprung piston: its frequency, and where weak coupling fails, against theory. Prints
/// one line a check; returns 0 when all hold, 1 otherwise. Takes seconds.
int selftest_command();

}  // namespace cosurge
