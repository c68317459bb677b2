#include "solid_solver/models/sprung/space_turning.hpp"

#include <cmath>
#include <numbers>

#include "common/error.hpp"

namespace cosurge::sprung {
namespace {

Vec<3> rotation_vector(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0 ? -1 : 1, sine = q.vec().norm();
  const double angle = 2 * std::atan2(sine, std::abs(q.w()));
  return sign * (sine > 1e-8 ? angle / sine : 2.0) * q.vec();
}

/// d theta / d psi transposed, on a vector: psi a small rotation in space on top of theta.
Vec<3> to_space(const Vec<3>& theta, const Vec<3>& gradient) {
  const double angle = theta.norm(), half = 0.5 * angle;
  const double c = angle > 1e-3 ? (1 - half / std::tan(half)) / (angle * angle) : 1. / 12;
  return gradient + 0.5 * theta.cross(gradient) + c * theta.cross(theta.cross(gradient));
}

/// Rotates further by the rotation with the Cayley vector psi; its angle is 2 atan(|psi| / 2).
Eigen::Quaterniond turned_on(const Eigen::Quaterniond& q, const Vec<3>& psi) {
  return (Eigen::Quaterniond(1, 0.5 * psi[0], 0.5 * psi[1], 0.5 * psi[2]) * q).normalized();
}

}  // namespace

double SpaceTurning::spring_energy(const Eigen::Quaterniond& at) const {
  const Vec<3> theta = rotation_vector(at);
  return 0.5 * theta.dot(stiffness.cwiseProduct(theta)) - preload.dot(theta);
}

/// Moment of the springs in a step that ends at `after`; psi . moment is the decrease of the springs' energy
/// [N m].
Vec<3> SpaceTurning::spring_moment(const Eigen::Quaterniond& after, const Vec<3>& psi) const {
  constexpr double too_small = 1e-7;  // [rad] too small for the difference of the energies to be accurate
  if (!has_springs()) return Vec<3>::Zero();
  const Vec<3> theta = rotation_vector(turned_on(attitude, 0.5 * psi));
  Vec<3> gradient = to_space(theta, stiffness.cwiseProduct(theta) - preload);
  if (const double square = psi.squaredNorm(); square > too_small * too_small)
    gradient += (spring_energy(after) - spring_energy(attitude) - gradient.dot(psi)) / square * psi;
  return -gradient;
}

/// The rotation vector is discontinuous at a rotation by half a turn.
void SpaceTurning::check_springs(const Eigen::Quaterniond& after) const {
  if (!has_springs() || (rotation_vector(after) - rotation_vector(attitude)).norm() < std::numbers::pi)
    return;
  throw NumericalError(
      "a rigid body has turned by 180 degrees, the limit for springs and preloads about turn_x, turn_y and "
      "turn_z (make them stiffer, or omit them)");
}

void SpaceTurning::step(const Moment& moment, double dt) {
  constexpr double tolerance = 1e-15;  // [rad]
  constexpr int most = 100;
  const Mat<3> before = rotation();
  const Mat<3> inverse = inertia.inverse();
  const Vec<3> spin = inverse * (before.transpose() * momentum);  // angular velocity in the body's frame
  Vec<3> psi = dt * (before * spin);
  for (int k = 0; k < most; ++k) {
    const Eigen::Quaterniond after = turned_on(attitude, psi);
    check_springs(after);
    const Mat<3> R = after.toRotationMatrix();
    const Vec<3> change =
        dt * (moment(0.5 * (before + R)) + spring_moment(after, psi)) - damping.cwiseProduct(psi);
    const Vec<3> next = 0.5 * dt * (before * (spin + inverse * (R.transpose() * (momentum + change))));
    const bool settled = (next - psi).norm() <= tolerance + tolerance * next.norm();
    psi = next;
    if (!settled) continue;
    attitude = after;
    momentum += change;
    return;
  }
  throw NumericalError(
      fmt::format("a rigid body turns at {:.3g} rad/s, and its moment of {:.3g} N m is too large for a step "
                  "of {:.3g} s (shorten time.window)",
                  speed().norm(), moment(before).norm(), dt));
}

}  // namespace cosurge::sprung
