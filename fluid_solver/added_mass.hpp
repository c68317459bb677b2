// The added mass of the structure's lowest modes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/participant.hpp"
#include "common/state_bytes.hpp"
#include "fluid_solver/bodies.hpp"
#include "fluid_solver/body_divergence.hpp"

namespace cosurge::fluid {

/// Effect of a motion of modes on the pressure at the wet points, r modes and n points.
struct ModalLoad {
  Eigen::VectorXd pressure;          ///< pressure for the predicted motion, negative values included [Pa]
  Eigen::MatrixXd per_acceleration;  ///< n x r: pressure per unit acceleration of each mode [Pa s2]
  Eigen::MatrixXd on_modes;          ///< r x n: load of a unit pressure on each mode [N/Pa]
  Eigen::VectorXd
      mobility;  ///< acceleration that a unit of load on each mode means for the window [1/(N s2)]
  Eigen::VectorXd predicted;   ///< load on each mode that the predicted motion was computed with [N]
  double lowest_pressure = 0;  ///< lower limit of the pressure [Pa]
};

/// The accelerations c of the modes, beyond the predicted motion, that agree with the load of the pressure
/// max(lowest, p + P c): c = S (B max(lowest, p + P c) - f), eq. (20). Newton's method; the matrix 1 - S B P
/// is the one of the added mass, positive definite.
Eigen::VectorXd consistent_accelerations(const ModalLoad& load);

/// Finds the load that agrees with the response of the structure's modes (docs/method.md, eq. 20). The
/// pressure of each mode is solved for with the matrix of the step: in every fourth window, in turn, starting
/// from its last solution. The equation is then solved once more for the motion that the modes get from the
/// load. In schemes that iterate over the window this is repeated until load and motion agree, because the
/// pressures of the modes can be up to three windows old.
template <int dim>
class AddedMass {
 public:
  /// The data of one step.
  struct Step {
    BodiesInWater<dim> bodies;
    const std::vector<Vec<dim>>& body_areas;
    const std::vector<Vec<dim>>& face_load;  ///< beyond -P A on the body points [N]
    Preconditioner& preconditioner;
    /// Change of the pressure source per divergence, by place [kg/(m3 s)]; empty if the source has no
    /// divergence. For a change of the bodies' velocity it is at least `least_per_change`.
    const std::vector<double>& source_per_divergence;
    double least_per_change;
    double dt;
    Attempt attempt;         ///< attempt at the window
    double tolerance;        ///< relative residual of the pressure equation
    double lowest_pressure;  ///< lower limit of the pressure [Pa]
  };

  /// Sets the modes for the next window; empty if the scheme uses none.
  void set_modes(const std::vector<Mode>& modes) { modes_ = modes; }

  /// Changes the pressures of the unknowns, those of the predicted motion, to those that agree with the load
  /// on the modes.
  void couple(const Step& step, std::vector<double>& pressure);

  double ratio() const { return ratio_; }  ///< largest ratio of a mode's added mass to its mass in the window
  int iterations() const { return iterations_; }  ///< for the modes in the last window

  /// Change of the body points' velocity in the window in addition to the predicted motion, dimension x
  /// points [m/s]; empty without modes.
  const Field& velocity_change() const { return velocity_change_; }

  void save(StateWriter& state) const;
  void restore(StateReader& state);

 private:
  std::vector<double> right_hand_side(const Step& step, const Field& shape) const;
  /// A wet point of the bodies whose pressure is unknown.
  struct WetPoint {
    std::size_t point, unknown;
  };

  std::vector<WetPoint> wet_points(const Step& step) const;
  ModalLoad modal_load(const Step& step, const std::vector<WetPoint>& points,
                       const std::vector<std::vector<double>>& mode_pressures) const;
  std::vector<double> last_pressure(const Step& step, std::size_t mode) const;
  std::vector<double> mode_pressure(const Step& step, std::size_t mode);
  void solve(const Step& step, const std::vector<double>& right_hand_side, double tolerance,
             std::vector<double>& p);
  Field motion_of(const Step& step, const Eigen::VectorXd& c) const;
  void answer(const Step& step, const Eigen::VectorXd& c, std::vector<double>& pressure);

  std::vector<Mode> modes_;
  std::vector<std::vector<double>> last_;  // pressure of each mode by the particles' id
  int windows_ = 0;  // number of coupled windows; decides which modes are solved for next
  Field velocity_change_;
  double ratio_ = 0;
  int iterations_ = 0;
};

}  // namespace cosurge::fluid
