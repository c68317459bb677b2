// cosurge selftest: a case with an exact answer, on the user's own machine.
#pragma once

namespace cosurge {

/// Compares a column of water on a sprung piston with theory: its frequency, and the stability limit of weak
/// coupling. Prints one line per check; returns 0 if all pass, 1 otherwise. Takes seconds.
int selftest_command();

}  // namespace cosurge
