// How long a step of the water may be.
#pragma once

namespace cosurge {

/// k_u of eq. (6c) over V / l0: walls that move at V are answered so many times in the time of a spacing.
inline constexpr double answers_to_walls = 15;

/// What limits a step of the water, eq. (17) of docs/method.md without the free flight of drops.
struct WaterStepLimits {
  double spacing;            ///< l0 [m]
  double gravity;            ///< |g| [m/s2]
  double viscosity;          ///< nu [m2/s]
  double propagation_speed;  ///< c of the source `time_scale` [m/s]; 0 with other sources
};

/// Longest step [s] at a Courant number, for water, walls and bodies of at most `speed` [m/s].
double longest_step(const WaterStepLimits& limits, double courant, double speed);

}  // namespace cosurge
