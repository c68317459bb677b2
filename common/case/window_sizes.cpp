#include "common/case/window_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "common/case/movers.hpp"
#include "common/case/water_depth.hpp"
#include "common/water_step.hpp"

namespace cosurge {

double longest_window(const v1::Case& the_case) {
  if (the_case.time().has_window()) return the_case.time().window();
  return std::min(the_case.time().end(), the_case.output().frame_interval());
}

double courant_number(const v1::Fluid& fluid, bool driven) {
  if (fluid.has_courant()) return fluid.courant();
  return fluid.source() == v1::Fluid::time_scale && !driven ? 0.5 : 0.2;
}

double expected_window(const v1::Case& the_case) {
  const double longest = longest_window(the_case);
  const v1::Fluid& fluid = the_case.fluid();
  if (fluid.water().empty() || the_case.time().stepping() == v1::Time::fixed) return longest;
  const WaterHeads heads = water_heads(the_case);
  const double default_speed = std::sqrt(heads.of_water + heads.gravity * fluid.spacing());
  const WaterStepLimits limits{.spacing = fluid.spacing(),
                               .gravity = heads.gravity,
                               .viscosity = fluid.kinematic_viscosity(),
                               .propagation_speed = fluid.source() != v1::Fluid::time_scale ? 0
                                                    : fluid.has_propagation_speed()
                                                        ? fluid.propagation_speed()
                                                        : default_speed};
  const double falling = 2 * std::sqrt(heads.above_tank);  // Ritter's bound of a front on a dry bed
  const auto window = [&](double driven) {
    const bool follows_walls = answers_to_walls * driven > limits.propagation_speed;
    return std::min(longest,
                    longest_step(limits, courant_number(fluid, follows_walls), std::max(falling, driven)));
  };
  const std::vector<double> driven = driven_speeds(the_case);
  if (driven.empty()) return window(0);
  double windows = 0;  // for each second
  for (const double speed : driven) windows += 1 / window(speed) / static_cast<double>(driven.size());
  return 1 / windows;
}

}  // namespace cosurge
