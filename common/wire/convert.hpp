// Between the plain structs of a participant and the messages of the wire. Whoever receives checks: every
// decode throws Error that names the field, and the point where one number is wrong, unless all lengths fit
// and all numbers are finite.
#pragma once

#include "common/participant.hpp"
#include "proto/exchange.pb.h"

namespace cosurge {

void encode(Role role, const Identity& identity, v1::Hello& message);
Role role_of(const v1::Hello& message);
Identity decode(const v1::Hello& message);

void encode(const Interface& interface, v1::Interface& message);
/// `bodies`: how many the case has.
Interface decode(const v1::Interface& message, int dimension, int bodies);

/// Displacement, velocity, modes and, unless it is zero everywhere, the ramp increment.
void encode(const InterfaceMotion& motion, v1::Motion& message);
/// Fills a motion that has its size already.
void decode(const v1::Motion& message, InterfaceMotion& motion);

/// Force and pressure.
void encode(const InterfaceLoad& load, v1::Load& message);
/// Fills a load that has its size already.
void decode(const v1::Load& message, InterfaceLoad& load);

/// A window that is gone through again gets attempt 2: whoever counts further attempts sets their number.
void encode(const Window& window, v1::Window& message);
Window decode(const v1::Window& message);

void encode(const Setup& setup, v1::Initialized& message);
Setup decode(const v1::Initialized& message);

void encode(const Report& report, v1::Advanced& message);
/// `columns`: number of columns in the setup.
Report decode(const v1::Advanced& message, std::size_t columns);

Snapshot decode(const v1::Snapshot& message);
/// @throws Error where a frame has more arrays than any needs.
void require_few_arrays(int count);

}  // namespace cosurge
