// The structure's lowest modes at the points of the interface.
#pragma once

#include <functional>
#include <vector>

#include "common/participant.hpp"
#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// Modes are those of the model, or of finite elements in its place where it does not know them. They are
/// found about the bodies where they are drawn, and turn with the bodies: with what carries a body, and a
/// free body of a model of large motion by the rotation that is nearest to the motion of its points.
class PointModes {
 public:
  /// @param interface the points; `count` the largest number of modes of each body
  template <int dim>
  PointModes(const Structure<dim>& structure, const Interface& interface, const SolidModel& model, int count);

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

  /// How the modes of a body turn.
  struct Turning {
    std::function<Eigen::MatrixXd(double t)>
        with_carrier;  // rotation of the carrier; empty: it does not move
    bool with_points;  // otherwise: as the points of the body
  };

  std::vector<PointMode> modes_of(const SolidModel& model, const Interpolation& H) const;
  Eigen::MatrixXd rotation(std::size_t body, double t, const Field& displacement) const;
  Field turned(const Field& shape, const std::vector<Eigen::MatrixXd>& rotations) const;

  Interface interface_;
  int count_;
  bool of_model_;                    // the model knows its modes
  std::vector<Turning> turnings_;    // of each body
  std::vector<PointMode> elements_;  // otherwise: those of finite elements
};

}  // namespace cosurge
