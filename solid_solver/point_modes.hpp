// The structure's lowest modes at the points of the interface.
#pragma once

#include <functional>
#include <vector>

#include "common/participant.hpp"
#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// Modes are those of the model, or of finite elements if the model does not know its modes. They are found
/// about the undeformed bodies and rotate with them: with the carrier of a body, and for a free body of a
/// model of large motion by the rotation nearest to the motion of its points (docs/method.md, after eq. 20).
class PointModes {
 public:
  /// @param interface the points; `count` the largest number of modes of each body
  template <int dim>
  PointModes(const Structure<dim>& structure, const Interface& interface, const SolidModel& model, int count);

  /// Response of each mode to another load over the window (docs/method.md, eq. 20).
  /// @param window the window that the model has just computed
  /// @param H from the nodes to the points (SolidModel::interpolation)
  /// @param displacement of the points at the end of the window [m]; force on them in the window [N]
  /// @param order of Stumpff's function in the mobility: 1 for the velocity at the end under a held load,
  /// plus one for the mean velocity, plus one for a ramped load
  std::vector<Mode> answers(const SolidModel& model, const Window& window, const Interpolation& H,
                            const Field& displacement, const Field& force, std::size_t order) const;

 private:
  struct PointMode {
    Field shape;  // dimension x points
    double mass;
    double omega_squared;
  };

  /// How the modes of a body rotate.
  struct Turning {
    std::function<Eigen::MatrixXd(double t)>
        with_carrier;  // rotation of the carrier; empty: it does not move
    bool with_points;  // if with_carrier is empty: with the points of the body
  };

  std::vector<PointMode> modes_of(const SolidModel& model, const Interpolation& H) const;
  Eigen::MatrixXd rotation(std::size_t body, double t, const Field& displacement) const;
  Field turned(const Field& shape, const std::vector<Eigen::MatrixXd>& rotations) const;

  Interface interface_;
  int count_;
  bool of_model_;                    // whether the model knows its modes
  std::vector<Turning> turnings_;    // rotation of the modes of each body
  std::vector<PointMode> elements_;  // modes of finite elements, if it does not
};

}  // namespace cosurge
