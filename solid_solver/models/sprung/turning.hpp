// Rotation of a rigid body in the plane, by any angle.
#pragma once

namespace cosurge::sprung {

/// Moment of dead forces f at X (relative to the pivot) on a body rotated by theta: across cos theta - along
/// sin theta, across = sum X x f, along = sum X . f [N m] (docs/method_solid.md, S30).
struct Couple {
  double across = 0;
  double along = 0;
};

/// I theta'' + damping theta' + stiffness theta = preload + moment(theta).
struct Turning {
  double inertia;    ///< about the pivot [kg m2]
  double stiffness;  ///< [N m/rad]
  double damping;    ///< [N m s/rad]
  double preload;    ///< [N m]
  double angle = 0;  ///< theta [rad]
  double speed = 0;  ///< [rad/s]

  /// One step of dt [s] by the mid-point rule, with the mean of the moment over the angle, so that the work
  /// of the forces on the body equals the change of its energies plus the loss in the damper exactly
  /// (docs/method_solid.md, S30). Second order, stable for any step.
  /// @throws NumericalError where the loads turn the body too fast for the step.
  void step(const Couple& couple, double dt);
};

}  // namespace cosurge::sprung
