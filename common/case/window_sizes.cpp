#include "common/case/window_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "common/case/water_depth.hpp"

namespace cosurge {

double longest_window(const v1::Case& the_case) {
  if (the_case.time().has_window()) return the_case.time().window();
  return std::min(the_case.time().end(), the_case.output().frame_interval());
}

double courant_number(const v1::Fluid& fluid, bool driven) {
  if (fluid.has_courant()) return fluid.courant();
  return fluid.source() == v1::Fluid::time_scale && !driven ? 0.4 : 0.2;
}

double expected_window(const v1::Case& the_case) {
  const double longest = longest_window(the_case);
  const v1::Fluid& fluid = the_case.fluid();
  if (fluid.water().empty() || the_case.time().stepping() == v1::Time::fixed) return longest;
  const int up = the_case.dimension() - 1;
  const double head = std::max(0.0, highest_water(the_case) - fluid.tank().min(up));
  const double gravity = std::abs(the_case.gravity(up));
  const double speed = 2 * std::sqrt(gravity * head);  // Ritter's bound of a front on a dry bed
  if (speed == 0) return longest;
  return std::min(longest, courant_number(fluid, false) * fluid.spacing() / speed);
}

}  // namespace cosurge
