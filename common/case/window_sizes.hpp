// How long the windows of a case may be.
#pragma once

#include "proto/case.pb.h"

namespace cosurge {

/// Longest window that the case allows [s]: time.window, or without it the interval of frames.
double longest_window(const v1::Case& the_case);

/// fluid.courant, or its default (measured, docs/decisions.md): 0.5 with `time_scale`, 0.2 while walls drive
/// the water; the other sources are unstable from 0.5 and have 0.2.
/// @param driven whether walls are so fast that the source follows them and not the water's own waves
double courant_number(const v1::Fluid& fluid, bool driven);

/// Typical window [s]: the longest, or what water allows that has fallen from its highest point to the lowest
/// point of the tank, in the direction of gravity, or that obstacles and bodies with a prescribed motion
/// drive: the mean of the run, as the end of the case over the number of windows.
double expected_window(const v1::Case& the_case);

}  // namespace cosurge
