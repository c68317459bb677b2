#include "coupler/lost_water.hpp"

#include <fmt/ranges.h>

namespace cosurge {

std::string lost_water(const Recorder& recorder) {
  const History* left = recorder.history("fluid/water");
  if (left == nullptr || recorder.windows() == 0) return "";
  const v1::Case& the_case = recorder.the_case();
  const v1::Box& tank = the_case.fluid().tank();
  double lost = 0;
  std::vector<std::string> places;
  for (int axis = 0; axis < the_case.dimension(); ++axis) {
    const char name = "xyz"[axis];
    for (const bool larger : {false, true}) {
      const History* side = recorder.history(fmt::format("fluid/lost_{}_{}", name, larger ? "max" : "min"));
      if (side == nullptr || !(side->last() > 0)) continue;
      lost += side->last();
      places.push_back(
          fmt::format("{:.0f} at {} = {:g} m", side->last(), name, larger ? tank.max(axis) : tank.min(axis)));
    }
  }
  if (lost == 0) return "";
  const double all = left->last() + lost;
  const History* over_rim = recorder.history("fluid/lost_over_rim");
  return fmt::format(
      "water lost: {:.0f} of {:.0f} particles ({:.2g} %) have left the tank: {}, {:.0f} of them over the rim",
      lost, all, 100 * lost / all, fmt::join(places, ", "), over_rim ? over_rim->last() : 0);
}

}  // namespace cosurge
