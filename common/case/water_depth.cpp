#include "common/case/water_depth.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/case/from_case.hpp"

namespace cosurge {
namespace {

template <int dim>
double extreme(const v1::Fluid& fluid, bool highest) {
  double value = highest ? std::numeric_limits<double>::lowest() : std::numeric_limits<double>::max();
  for (const v1::Shape& water : fluid.water()) {
    const auto shape = from_case<dim>(water);
    const Box<dim>& bounds = shape.bounds();
    value = highest ? std::max(value, bounds.max[dim - 1]) : std::min(value, bounds.min[dim - 1]);
  }
  return value;
}

/// Extremes of -g . x over a box [m2/s2].
template <int dim>
std::pair<double, double> potentials(const Box<dim>& box, const Vec<dim>& gravity) {
  const Vec<dim> at_min = (-gravity).cwiseProduct(box.min), at_max = (-gravity).cwiseProduct(box.max);
  return {at_min.cwiseMin(at_max).sum(), at_min.cwiseMax(at_max).sum()};
}

template <int dim>
WaterHeads heads_of(const v1::Case& the_case) {
  const Vec<dim> gravity = from_case<dim>(the_case.gravity());
  double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();
  for (const v1::Shape& water : the_case.fluid().water()) {
    const auto [low, high] = potentials<dim>(from_case<dim>(water).bounds(), gravity);
    lowest = std::min(lowest, low);
    highest = std::max(highest, high);
  }
  const double bottom = potentials<dim>(from_case<dim>(the_case.fluid().tank()), gravity).first;
  return {
      .gravity = gravity.norm(), .of_water = highest - lowest, .above_tank = std::max(0.0, highest - bottom)};
}

}  // namespace

WaterHeads water_heads(const v1::Case& the_case) {
  return the_case.dimension() == 2 ? heads_of<2>(the_case) : heads_of<3>(the_case);
}

double highest_water(const v1::Case& the_case) {
  const v1::Fluid& fluid = the_case.fluid();
  return the_case.dimension() == 2 ? extreme<2>(fluid, true) : extreme<3>(fluid, true);
}

double lowest_water(const v1::Case& the_case) {
  const v1::Fluid& fluid = the_case.fluid();
  return the_case.dimension() == 2 ? extreme<2>(fluid, false) : extreme<3>(fluid, false);
}

}  // namespace cosurge
