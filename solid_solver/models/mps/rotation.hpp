// Rotations of particles, several at a time.
#pragma once

#include "solid_solver/models/particles/lanes.hpp"

namespace cosurge::mps {

using particles::Lanes;
using particles::LaneVec;

/// A rotation by its half angle: in the plane the unit complex number (cos(theta / 2), sin(theta / 2)). A
/// third dimension would make it a quaternion, with the same members.
template <int dim>
struct Rotation;

template <>
struct Rotation<2> {
  static constexpr int components = 2;
  static constexpr int spins = 1;  ///< components of the angular velocity

  Lanes c, s;

  static std::array<double, components> identity() { return {1, 0}; }

  /// The rotation by the mean of two particles' angles (S1): the product of their half-angle rotations.
  struct Mean {
    Lanes cosine, sine;
    LaneVec<2> apply(const std::array<double, 2>& x) const {
      return {x[0] * cosine - x[1] * sine, x[0] * sine + x[1] * cosine};
    }
  };
  Mean mean(const Rotation& other) const { return {c * other.c - s * other.s, s * other.c + c * other.s}; }

  /// Turned on by angle = angular velocity * dt, with |angle| < 0.4 for all digits: the half angle's sine and
  /// cosine are their Taylor polynomials. One Newton step holds the modulus at 1 against rounding.
  Rotation turned(const std::array<Lanes, spins>& angle) const {
    const Lanes a = 0.5 * angle[0];
    const Lanes a2 = a * a;
    const Lanes sine =
        a * (1 - a2 * (1. / 6) * (1 - a2 * (1. / 20) * (1 - a2 * (1. / 42) * (1 - a2 * (1. / 72)))));
    const Lanes cosine =
        1 - a2 * (1. / 2) *
                (1 - a2 * (1. / 12) * (1 - a2 * (1. / 30) * (1 - a2 * (1. / 56) * (1 - a2 * (1. / 90)))));
    const Lanes c1 = c * cosine - s * sine;
    const Lanes s1 = s * cosine + c * sine;
    const Lanes scale = 1.5 - 0.5 * (c1 * c1 + s1 * s1);
    return {c1 * scale, s1 * scale};
  }
};

/// x * y, in the plane its one component.
inline std::array<Lanes, 1> cross(const LaneVec<2>& x, const LaneVec<2>& y) {
  return {x[0] * y[1] - x[1] * y[0]};
}

}  // namespace cosurge::mps
