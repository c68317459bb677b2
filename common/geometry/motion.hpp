// The prescribed motion of a rigid wall.
#pragma once

#include "common/geometry/lattice.hpp"

namespace cosurge {

/// A displacement [m] along each axis, and last the angle [rad] of a rotation in the plane of the first and
/// the last coordinate, from the first to the last.
template <int dim>
using Pose = Eigen::Matrix<double, dim + 1, 1>;

/// A motion by a formula: amplitude x (s(t) - s(0)) with s = ramp(t) sin(2 pi f t + phase) and a half cosine
/// as the ramp.
template <int dim>
struct Oscillation {
  Pose<dim> amplitude;
  double frequency;  ///< f [Hz]
  double phase;      ///< [rad]
  double ramp;       ///< time in which the motion grows from zero [s]
};

/// A motion by a table of poses.
template <int dim>
struct PoseTable {
  std::vector<double> time;  ///< of each row, ascending [s]
  std::vector<Pose<dim>> row;
};

/// Displacement and rotation as functions of time, both zero at t = 0: by a formula, by a table, or none at
/// all. Between the rows of a table runs a cubic Hermite spline with slopes that are limited so that it is
/// monotone there (Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17, 238): it never leaves the range of the
/// two rows, and rests where they are equal. Before the first row and after the last the wall stands still.
template <int dim>
class Motion {
 public:
  Motion() = default;  ///< at rest

  /// @param pivot centre of the rotation [m]
  Motion(const Oscillation<dim>& oscillation, const Vec<dim>& pivot);
  Motion(PoseTable<dim> table, const Vec<dim>& pivot);

  /// A constant velocity [m/s].
  explicit Motion(const Vec<dim>& velocity) : uniform_(velocity) {}

  /// Whether the wall moves at all.
  bool moves() const { return formula_.frequency > 0 || !table_.row.empty() || !uniform_.isZero(); }

  /// Where the wall's point X is at time t [s].
  Vec<dim> place(const Vec<dim>& X, double t) const;

  /// The point of the wall at rest that is at x at time t.
  Vec<dim> origin(const Vec<dim>& x, double t) const;

  /// The velocity at time t of the wall's point X; at t = 0 that of a motion that begins with a speed [m/s].
  Vec<dim> velocity(const Vec<dim>& X, double t) const;

  /// The rotation from the start to time t.
  Mat<dim> turned(double t) const { return rotation(pose(t)[dim]); }

  /// A box around all places that the points of `box` ever take, from samples of the motion.
  Box<dim> sweep(const Box<dim>& box) const;

 private:
  using Pose = cosurge::Pose<dim>;

  Pose pose(double t) const;
  Pose from_table(double t) const;
  std::vector<Pose> slopes() const;
  Mat<dim> rotation(double angle) const;
  std::vector<double> samples() const;

  Vec<dim> pivot_ = Vec<dim>::Zero();
  Oscillation<dim> formula_ = {.amplitude = Pose::Zero(), .frequency = 0, .phase = 0, .ramp = 0};
  PoseTable<dim> table_;
  Vec<dim> uniform_ = Vec<dim>::Zero();
  std::vector<Pose> slope_;  // at the rows of the table
};

}  // namespace cosurge
