// Probes that lie beside a body by a rounding.
#pragma once

#include "proto/case.pb.h"

namespace cosurge {

/// Moves probes onto the surface of the nearest body, except level probes, if they lie outside every body by
/// less than a hundredth of a spacing: coordinates of outlines are rounded. (Farther away, a pressure probe
/// measures the water beside the body.)
void snap_probes(v1::Case& the_case);

/// Where the nearest body is: "solid.body.0 is 0.02 m away, at (0.1, 0.05)". Empty if there is no body.
std::string nearest_body(const v1::Case& the_case, const v1::Probe& probe);

/// What to say of a probe of pressure that lies in a body or obstacle, farther from its surface than a
/// spacing; else nothing.
std::string too_deep(const v1::Case& the_case, const v1::Probe& probe);

}  // namespace cosurge
