#include "common/case/window_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "common/case/from_case.hpp"

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
  if (!the_case.has_fluid() || the_case.time().stepping() == v1::Time::fixed) return longest;
  double head = 0;
  const int up = the_case.dimension() - 1;
  for (const v1::Shape& water : the_case.fluid().water()) {
    const double top = up == 1 ? from_case<2>(water).bounds().max[1] : from_case<3>(water).bounds().max[2];
    head = std::max(head, top - the_case.fluid().tank().min(up));
  }
  const double gravity = std::abs(the_case.gravity(up));
  const double speed = 2 * std::sqrt(gravity * head);  // Ritter's bound of a front on a dry bed
  if (speed == 0) return longest;
  return std::min(longest, courant_number(the_case.fluid(), false) * the_case.fluid().spacing() / speed);
}

}  // namespace cosurge
