#include "common/water_step.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge {

double longest_step(const WaterStepLimits& limits, double courant, double speed) {
  constexpr double none = 1e-12;
  constexpr double fall = 0.4;     // of sqrt(l0 / g): longer steps throw single particles of falling water
  constexpr double diffuse = 0.2;  // of l0^2 / nu, stability of the explicit viscosity
  constexpr double correct = 0.5;  // of l0 / c: water at rest is unstable if a step corrects all density
  double longest =
      std::min({courant * limits.spacing / std::max(speed, none),
                diffuse * limits.spacing * limits.spacing / std::max(limits.viscosity, none),
                std::min(fall, courant) * std::sqrt(limits.spacing / std::max(limits.gravity, none))});
  if (limits.propagation_speed > 0)
    longest = std::min(longest, correct * limits.spacing / limits.propagation_speed);
  return longest;
}

}  // namespace cosurge
