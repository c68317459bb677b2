// The structure's lowest modes at the points of the interface.
#pragma once

#include <vector>

#include "common/participant.hpp"
#include "proto/case.pb.h"
#include "solid_solver/solid_model.hpp"

namespace cosurge {

/// Modes are those of the model, or of finite elements in its place where it does not know them. They are
/// found about the bodies where they are drawn, and turn with the bodies: with what carries a body, and a
/// free body of a model of large motion by the rotation that is nearest to the motion of its points.
class PointModes {
 public:
  /// @param interface the points; `count` the largest number of modes of each body
  PointModes(const v1::Case& the_case, const Interface& interface, const SolidModel& model, int count);

  /// How each mode answers another load over the window (docs/method.md, eq. 20).
  /// @param window that the model has just gone through
  /// @param H of the points
  /// @param displacement of the points at the end of the window [m]; force on them in the window [N]
  /// @param order of Stumpff's function that gives the velocity which the water sees: 1 the one at the end
  /// under a held load, one more for the mean, one more for a ramped load
  std::vector<Mode> answers(const SolidModel& model, const Window& window, const Interpolation& H,
                            const Field& displacement, const Field& force, std::size_t order) const;

 private:
  struct PointMode {
    Field shape;  // dimension x points
    double mass;
    double omega_squared;
  };

  std::vector<PointMode> modes_of(const SolidModel& model, const Interpolation& H) const;
  Eigen::MatrixXd rotation(int body, double t, const Field& displacement) const;
  Field turned(const Field& shape, const std::vector<Eigen::MatrixXd>& rotations) const;

  v1::Case case_;
  Interface interface_;
  int count_;
  bool of_model_;                    // the model knows its modes
  std::vector<PointMode> elements_;  // otherwise: those of finite elements
};

}  // namespace cosurge
