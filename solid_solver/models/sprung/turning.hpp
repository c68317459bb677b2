// Rotation of a rigid body in the plane, by any angle.
#pragma once

namespace cosurge::sprung {

/// Moment of dead forces f at X (from the pivot) on a body turned by theta: across cos theta - along sin
/// theta, across = sum X x f, along = sum X . f [N m].
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

  /// One step of dt by the mid-point rule, with the moment's mean over the angle, so that forces do on the
  /// body exactly the work that its energies and damper take (docs/method_solid.md, S30). Second order,
  /// stable for any step.
  /// @throws NumericalError where the loads turn the body too fast for the step.
  void step(const Couple& couple, double dt);
};

}  // namespace cosurge::sprung
