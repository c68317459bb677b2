#include "solid_solver/damping.hpp"

#include <cmath>

#include "common/error.hpp"
#include "solid_solver/models/modal/modes.hpp"

namespace cosurge {

template <int dim>
std::vector<double> damping_rates(const Structure<dim>& structure) {
  std::vector<double> rates(structure.bodies.size(), 0.0);
  if (structure.damping_ratio == 0) return rates;
  for (std::size_t b = 0; b < rates.size(); ++b) {
    const double omega_squared = modal::lowest_of_body(structure, b, 1).omega_squared[0];
    require(omega_squared > 0,
            "solid.damping_ratio: solid.body.{} is free to move as a whole; hold it, or omit the damping", b);
    rates[b] = 2 * structure.damping_ratio * std::sqrt(omega_squared);
  }
  return rates;
}

template std::vector<double> damping_rates<2>(const Structure<2>&);
template std::vector<double> damping_rates<3>(const Structure<3>&);

}  // namespace cosurge
