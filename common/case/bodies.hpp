// The bodies of a case: their shapes, and the lattice of their particles.
#pragma once

#include "proto/case.pb.h"

namespace cosurge {

v1::Shape shape_of(const v1::Box& box);

/// The shape of a body, which the case gives as a box or as any shape.
v1::Shape shape_of(const v1::Body& body);

/// The first body that contains a point, to rounding; -1: no body.
int body_at(const v1::Solid& solid, const google::protobuf::RepeatedField<double>& position);

/// Spacing of the structure's particles, the solid's own or the fluid's [m].
/// @throws Error where neither has one
double solid_spacing(const v1::Case& the_case);

}  // namespace cosurge
