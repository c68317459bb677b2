// The prescribed motion of a rigid wall.
#pragma once

#include "common/geometry/lattice.hpp"

namespace cosurge {

/// Displacement and rotation as functions of time, both zero at t = 0: by a formula, amplitude x (s(t) -
/// s(0)) with s = ramp(t) sin(2 pi f t + phase) and a half cosine as the ramp, or by a table. Between its
/// rows runs a cubic Hermite spline with slopes that are limited so that it is monotone there (Fritsch &
/// Carlson 1980, SIAM J. Numer. Anal. 17, 238): it never leaves the range of the two rows, and rests where
/// they are equal. Before the first row and after the last the wall stands still.
template <int dim>
class Motion {
 public:
  explicit Motion(const v1::WallMotion& motion);

  /// Whether the wall moves at all.
  bool moves() const { return frequency_ > 0 || !row_.empty(); }

  /// Where the wall's point X is at time t [s].
  Vec<dim> place(const Vec<dim>& X, double t) const;

  /// The point of the wall at rest that is at x at time t.
  Vec<dim> origin(const Vec<dim>& x, double t) const;

  /// The velocity at time t of the wall's point X [m/s].
  Vec<dim> velocity(const Vec<dim>& X, double t) const;

  /// The rotation from the start to time t.
  Mat<dim> turned(double t) const { return rotation(pose(t)[dim]); }

  /// A box around all places that the points of `box` ever take, from samples of the motion.
  Box<dim> sweep(const Box<dim>& box) const;

 private:
  /// Displacement, and the angle last.
  using Pose = Eigen::Matrix<double, dim + 1, 1>;

  Pose pose(double t) const;
  Pose from_table(double t) const;
  std::vector<Pose> slopes() const;
  Mat<dim> rotation(double angle) const;
  std::vector<double> samples() const;

  Pose amplitude_ = Pose::Zero();
  Vec<dim> pivot_ = Vec<dim>::Zero();
  double frequency_;  // [Hz]; 0: a table, or no motion
  double phase_;
  double ramp_;               // [s]
  std::vector<double> time_;  // times of the table's rows
  std::vector<Pose> row_;
  std::vector<Pose> slope_;  // at the rows
};

}  // namespace cosurge
