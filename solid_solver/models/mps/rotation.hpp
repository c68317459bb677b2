// Rotations of particles, several at a time.
#pragma once

#include "solid_solver/models/particles/lanes.hpp"

namespace cosurge::mps {

using particles::cross;
using particles::Lanes;
using particles::LaneVec;

/// cos a and sin a / a from a^2, by Taylor polynomials that are exact to rounding for |a| < 0.2.
struct SmallAngle {
  Lanes cosine, sine_over_angle;
  explicit SmallAngle(const Lanes& a2)
      : cosine(1 -
               a2 * (1. / 2) *
                   (1 - a2 * (1. / 12) * (1 - a2 * (1. / 30) * (1 - a2 * (1. / 56) * (1 - a2 * (1. / 90)))))),
        sine_over_angle(1 -
                        a2 * (1. / 6) * (1 - a2 * (1. / 20) * (1 - a2 * (1. / 42) * (1 - a2 * (1. / 72))))) {}
};

/// A rotation, stored by its half angle: in the plane the unit complex number (cos(theta / 2), sin(theta /
/// 2)), in space the unit quaternion. `Pair` holds what the rotations of two particles give together (S1,
/// S38, S39).
template <int dim>
struct Rotation;

template <>
struct Rotation<2> {
  static constexpr int components = 2;
  static constexpr int spins = 1;  ///< components of the angular velocity
  using Axial = std::array<Lanes, spins>;

  std::array<Lanes, components> q;

  struct Pair {
    Lanes cosine, sine;            // mean angle
    Lanes half_cosine, half_sine;  // half the angle between the two

    /// x, turned by the mean rotation (S1).
    LaneVec<2> turn(const std::array<double, 2>& x) const {
      return {x[0] * cosine - x[1] * sine, x[0] * sine + x[1] * cosine};
    }
    /// Twice the share of the first particle in a couple on the mean rotation; each gets half of it.
    Axial share(const Axial& couple) const { return couple; }
    Axial twist() const { return {2 * half_cosine * half_sine}; }  ///< sine of the relative angle (S38)
    Lanes one_minus_cosine() const { return 2 * half_sine * half_sine; }  ///< for the relative angle
  };

  Pair with(const Rotation& other) const {
    const auto &a = q, &b = other.q;
    return {a[0] * b[0] - a[1] * b[1], a[1] * b[0] + a[0] * b[1], a[0] * b[0] + a[1] * b[1],
            a[0] * b[1] - a[1] * b[0]};
  }

  /// Rotates further by the angle angular velocity * dt, |angle| < 0.4. One Newton step keeps the modulus at
  /// 1 despite rounding.
  Rotation turned(const Axial& angle) const {
    const Lanes a = 0.5 * angle[0];
    const SmallAngle small(a * a);
    const Lanes sine = a * small.sine_over_angle;
    const Lanes c = q[0] * small.cosine - q[1] * sine;
    const Lanes s = q[1] * small.cosine + q[0] * sine;
    const Lanes scale = 1.5 - 0.5 * (c * c + s * s);
    return {{c * scale, s * scale}};
  }
};

template <>
struct Rotation<3> {
  static constexpr int components = 4;
  static constexpr int spins = 3;
  using Axial = LaneVec<3>;

  std::array<Lanes, components> q;  // scalar first

  struct Pair {
    Lanes scalar, over_square;  // scalar part of the sum of both quaternions, and 2 over its square
    LaneVec<3> vector;
    Lanes half_cosine;     // half the angle between the two
    LaneVec<3> half_sine;  // times the axis

    LaneVec<3> turn(const std::array<double, 3>& x) const {
      const LaneVec<3> once = {vector[1] * x[2] - vector[2] * x[1], vector[2] * x[0] - vector[0] * x[2],
                               vector[0] * x[1] - vector[1] * x[0]};
      const LaneVec<3> twice = cross(vector, once);
      LaneVec<3> turned;
      for (int k = 0; k < 3; ++k) turned[k] = x[k] + over_square * (scalar * once[k] + twice[k]);
      return turned;
    }
    /// With t = tan(psi / 4) n of the relative rotation (psi, n), the share of the first particle in the mean
    /// rotation is (1 - t x) / 2, so that couples are the derivative of the energy (S39).
    Axial share(const Axial& couple) const {
      const Lanes scale = 1 / (1 + half_cosine);
      const LaneVec<3> aside = cross(half_sine, couple);
      Axial mine;
      for (int k = 0; k < 3; ++k) mine[k] = couple[k] - scale * aside[k];
      return mine;
    }
    Axial twist() const {
      Axial sine;
      for (int k = 0; k < 3; ++k) sine[k] = 2 * half_cosine * half_sine[k];
      return sine;
    }
    Lanes one_minus_cosine() const {
      return 2 * (half_sine[0].square() + half_sine[1].square() + half_sine[2].square());
    }
  };

  Pair with(const Rotation& other) const {
    const auto &a = q, &b = other.q;
    const LaneVec<3> va = {a[1], a[2], a[3]}, vb = {b[1], b[2], b[3]};
    const LaneVec<3> across = cross(va, vb);
    Pair pair;
    pair.scalar = a[0] + b[0];
    pair.half_cosine = a[0] * b[0];
    Lanes square = pair.scalar.square();
    for (int k = 0; k < 3; ++k) {
      pair.vector[k] = va[k] + vb[k];
      square += pair.vector[k].square();
      pair.half_cosine += va[k] * vb[k];
      pair.half_sine[k] = a[0] * vb[k] - b[0] * va[k] + across[k];
    }
    pair.over_square = 2 / square;
    return pair;
  }

  Rotation turned(const Axial& angle) const {
    const LaneVec<3> v = {q[1], q[2], q[3]}, half = {0.5 * angle[0], 0.5 * angle[1], 0.5 * angle[2]};
    const SmallAngle small(half[0].square() + half[1].square() + half[2].square());
    LaneVec<3> a;
    for (int k = 0; k < 3; ++k) a[k] = small.sine_over_angle * half[k];
    const LaneVec<3> across = cross(a, v);
    Rotation next{{small.cosine * q[0] - a[0] * v[0] - a[1] * v[1] - a[2] * v[2], {}, {}, {}}};
    Lanes square = next.q[0].square();
    for (int k = 0; k < 3; ++k) {
      next.q[k + 1] = small.cosine * v[k] + a[k] * q[0] + across[k];
      square += next.q[k + 1].square();
    }
    const Lanes scale = 1.5 - 0.5 * square;
    for (Lanes& component : next.q) component *= scale;
    return next;
  }
};

}  // namespace cosurge::mps
