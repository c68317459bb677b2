// The solvers as participants; each is defined in its own folder.
#pragma once

#include <memory>

#include "common/participant.hpp"

namespace cosurge {

std::unique_ptr<Fluid> make_fluid_solver();  // fluid_solver/fluid_participant.cpp
std::unique_ptr<Solid> make_solid_solver();  // solid_solver/solid_participant.cpp

}  // namespace cosurge
