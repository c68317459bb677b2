// Cases with several structures [[solid]], each computed by a solver of its own.
#pragma once

#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

inline bool has_several_solids(const v1::Case& the_case) { return the_case.solids_size() > 0; }

/// The structures of a case: their names, or "solid" for a single [solid].
std::vector<std::string> solid_names(const v1::Case& the_case);

/// The structure that a body of `the_case.solid()` belongs to.
const v1::Solid& solid_of(const v1::Case& the_case, const v1::Body& body);

/// Number of the first body of a structure among those of `the_case.solid()`.
int first_body(const v1::Case& the_case, int solid);

/// Gives `the_case.solid()` the bodies of all [[solid]], one structure after the other. A single [[solid]]
/// becomes [solid].
void join_solids(v1::Case& the_case);

/// The case of one structure, for its solver: [solid] with its own bodies, and the displacement probes on
/// them. Clamps in a rigid body of another structure get the motion of that body.
v1::Case case_of_solid(const v1::Case& the_case, int solid);

/// A text with keys of `the_case.solid()`, with those of the case file: "solid.body.3" becomes
/// "solid.1.body.0".
std::string with_written_keys(const v1::Case& the_case, const std::string& text);

/// The same for keys of case_of_solid(): "solid.model" becomes "solid.1.model".
std::string with_written_keys(int solid, const std::string& text);

}  // namespace cosurge
