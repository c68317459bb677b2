// Finds what a probe of the water is fixed to.
#pragma once

#include "common/geometry/probe_mount.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// The first body that the probe lies in or on; else the first obstacle; else the face of the tank; each to a
/// hundredth of a spacing.
ProbeMount mount_of(const v1::Case& the_case, const v1::Probe& probe);

}  // namespace cosurge
