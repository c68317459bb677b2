// One rigid body on springs and dampers.
#pragma once

#include <array>
#include <optional>

#include "common/state_bytes.hpp"
#include "solid_solver/models/sprung/revolution.hpp"
#include "solid_solver/oscillator.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge::sprung {

/// Translations along the axes and rotations by any angle about a pivot, each with its spring and damper
/// (docs/method_solid.md, section 8). Motions without a spring in the case are fixed. The nodes are the pivot
/// and one point at a distance from it along each axis: the rigid motion is affine between them, so that H is
/// constant for large rotations too.
template <int dim>
class SprungBody {
 public:
  static constexpr int nodes = dim + 1;
  using Nodal = Eigen::Matrix<double, dim, nodes>;
  using Coefficients = Eigen::Matrix<double, nodes, 1>;

  /// @param index of the body, for messages
  /// @param velocity at the start, along free axes [m/s]
  SprungBody(const Shape<dim>& shape, std::size_t index, const SprungParameters<dim>& parameters,
             double density, const Vec<dim>& gravity, const Vec<dim>& velocity);

  /// Coefficients of the nodes' motions in the motion of a point.
  Coefficients coefficients(const Vec<dim>& x) const;

  /// Computes one window under a load on the nodes that changes linearly from first to last [N]. Returns the
  /// number of sub-steps of the rotation; translations are exact in time.
  int advance(double window, const Nodal& first, const Nodal& last);

  /// Initial positions of its nodes [m].
  Field position() const;

  /// M a [N] for a rigid body, whose acceleration between the nodes is affine like its motion.
  Field inertia(const Field& acceleration) const { return acceleration * nodal_mass_; }

  /// Its free motions about the present position.
  std::vector<NodalMode> modes() const;

  Field displacement() const;  ///< [m]
  Field velocity() const;      ///< [m/s]
  Field ramp_increment() const { return ramp_increment_; }
  Energies energies() const;  ///< `elastic` is the energy of the springs, zero in the initial position
  double max_speed() const;   ///< [m/s] of its corners

  void save(StateWriter& state) const;
  void restore(StateReader& state);

 private:
  struct Translation {
    bool free = false;
    Spring spring = {.stiffness = 0, .damping = 0, .preload = 0};
    OscillatorState state;
  };

  Shape<dim> shape_;
  Vec<dim> pivot_, arm_to_centre_, gravity_;
  double length_;  // length of the nodes' arms [m]
  double mass_;
  Eigen::Matrix<double, nodes, nodes>
      nodal_mass_;  // integral of the density times products of coefficients [kg]
  std::array<Translation, dim> translations_;
  std::optional<Revolution<dim>> turning_;  // set as soon as the inertia is known
  Nodal ramp_increment_ = Nodal::Zero();
};

}  // namespace cosurge::sprung
