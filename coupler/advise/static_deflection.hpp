// Deflection of plates, beams and layers under water at rest.
#pragma once

#include <optional>

#include "proto/case.pb.h"

namespace cosurge {

/// How clamps hold a box.
struct Hold {
  enum Kind {
    other,       ///< free, supported, an outline, or clamped in another way
    cantilever,  ///< clamped at one end, at least twice as long as thick
    fixed,       ///< clamped at both ends of its length, likewise
    layer        ///< clamped over one of its two large faces
  };
  Kind kind = other;
  int thickness = 0;      ///< axis of the shortest side
  int length = 0;         ///< axis along which it is clamped
  bool at_upper = false;  ///< a cantilever is clamped at the upper end of this axis
};

/// M [Pa], the modulus of compression without lateral strain, see below.
double layer_modulus(const v1::Solid& solid);

/// How the clamps of a body hold it.
Hold hold_of(const v1::Body& body, int dimension);

/// Largest static deflection [m] of a body under the hydrostatic pressure rho g z of water on one side, whose
/// surface lies at the highest water of the start. Linear, small deflection, without shear, which adds 0.8
/// (1 + nu) (t / L)^2 of it to a cantilever:
///   cantilever  integral of q(s) s^2 (3 L - s) / (6 E' I) ds at the free end, s from the clamp
///   fixed       integral of q(s) s^2 (3 L - 4 s) / (48 E' I) ds over both halves at the middle, s from the
///               nearer end (both: Timoshenko, Strength of Materials I, loads at a point superposed)
///   layer       q t / M, M = E (1 - nu) / ((1 + nu) (1 - 2 nu)): compression without lateral strain
/// I = t^3 / 12 per width. E' = E / (1 - nu^2) in plane strain, and in space if the body is at least as wide
/// as long; otherwise E. Nothing where the body is none of these, has no modulus, or lies above that water.
std::optional<double> static_deflection(const v1::Case& the_case, int body);

}  // namespace cosurge
