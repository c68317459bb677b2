// Threads that wait asleep: on a shared machine OpenMP's spinning barriers slow everything down a
// hundredfold.
#pragma once

namespace cosurge {

/// GOMP_SPINCOUNT, where the user has not set it: some microseconds of spinning before a thread falls asleep.
/// It bridges the gaps between the loops of one solve; a hundred times as much was ten times slower on a
/// machine with other work.
inline constexpr const char* short_spin = "300";

/// OpenMP reads OMP_WAIT_POLICY once, before main: where it is not set, sets it to passive and starts this
/// program anew in the same process. Call it first in main.
void ensure_passive_waiting(char** argv);

/// Number of threads in the parallel regions of the calling thread; 0 leaves it to OpenMP.
void set_threads(int threads);

}  // namespace cosurge
