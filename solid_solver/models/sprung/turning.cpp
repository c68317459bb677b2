#include "solid_solver/models/sprung/turning.hpp"

#include <cmath>

#include "common/error.hpp"

namespace cosurge::sprung {

void Turning::step(const Couple& couple, double dt) {
  constexpr double tolerance = 1e-15;  // [rad]
  constexpr int most = 100;
  const double stiff = inertia + 0.5 * dt * damping + 0.25 * dt * dt * stiffness;
  double change = dt * speed;
  for (int k = 0; k < most; ++k) {
    const double middle = angle + 0.5 * change, half = 0.5 * change;
    const double sinc = std::abs(half) > 1e-4 ? std::sin(half) / half : 1 - half * half / 6;
    const double moment = sinc * (couple.across * std::cos(middle) - couple.along * std::sin(middle));
    const double next =
        (inertia * dt * speed + 0.5 * dt * dt * (preload + moment - stiffness * angle)) / stiff;
    const bool settled = std::abs(next - change) <= tolerance + tolerance * std::abs(next);
    change = next;
    if (!settled) continue;
    angle += change;
    speed = 2 * change / dt - speed;
    return;
  }
  throw NumericalError(
      fmt::format("a rigid body turns at {:.3g} rad/s, and its moment of {:.3g} N m is too large for a step "
                  "of {:.3g} s (shorten time.window)",
                  speed, couple.across, dt));
}

}  // namespace cosurge::sprung
