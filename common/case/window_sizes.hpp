// How long the windows of a case may be.
#pragma once

#include "proto/case.pb.h"

namespace cosurge {

/// Longest window that the case allows [s]: time.window, or without it the interval of frames.
double longest_window(const v1::Case& the_case);

/// Typical window [s]: the longest, or what water that has fallen from its highest point allows.
double expected_window(const v1::Case& the_case);

}  // namespace cosurge
