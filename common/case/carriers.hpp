// Prescribed motions of obstacles and of the holders of bodies.
#pragma once

#include "proto/case.pb.h"

namespace cosurge {

/// Whether a prescribed motion moves anything: one with neither a table nor a frequency is at rest.
bool moves(const v1::WallMotion& motion);

/// The motion of an obstacle: its own, or else the tank's.
const v1::WallMotion& motion_of(const v1::Fluid& fluid, const v1::Obstacle& obstacle);

/// Whether clamps, supports or springs hold the body, or its model `rigid` does.
bool is_held(const v1::Solid& solid, const v1::Body& body);

/// Whether the body is held, and by something that does not move in the tank. A body on springs is free.
bool is_held_at_rest(const v1::Case& the_case, const v1::Body& body);

/// Whether a clamp of the body lies in a body of another structure, and the body has no motion of its own.
bool is_held_by_another(const v1::Case& the_case, const v1::Body& body);

/// The motion of a body's holder: its own, else that of the obstacle, or of the rigid body of another
/// structure, in which its clamps lie, else the tank's. Empty if nothing holds the body.
/// @throws Error where its clamps lie in things that move differently, or in a body whose motion is computed.
v1::WallMotion motion_of(const v1::Case& the_case, const v1::Body& body);

}  // namespace cosurge
