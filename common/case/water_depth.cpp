#include "common/case/water_depth.hpp"

#include <algorithm>
#include <limits>

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

}  // namespace

double highest_water(const v1::Case& the_case) {
  const v1::Fluid& fluid = the_case.fluid();
  return the_case.dimension() == 2 ? extreme<2>(fluid, true) : extreme<3>(fluid, true);
}

double lowest_water(const v1::Case& the_case) {
  const v1::Fluid& fluid = the_case.fluid();
  return the_case.dimension() == 2 ? extreme<2>(fluid, false) : extreme<3>(fluid, false);
}

}  // namespace cosurge
