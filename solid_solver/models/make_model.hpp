// The one switch from a case to a solid model.
#pragma once

#include <memory>

#include "proto/case.pb.h"
#include "solid_solver/solid_model.hpp"

namespace cosurge {

/// @throws Error for a case whose solid has no spacing of its own and no fluid to take it from, for
/// dimensions that the model does not have, and for what the model itself refuses.
std::unique_ptr<SolidModel> make_model(const v1::Case& the_case);

}  // namespace cosurge
