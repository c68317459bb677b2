#include "solid_solver/damping.hpp"

#include <cmath>

#include "common/error.hpp"
#include "solid_solver/models/modal/modes.hpp"

namespace cosurge {

template <int dim>
std::vector<double> damping_rates(const v1::Solid& solid) {
  std::vector<double> rates(static_cast<std::size_t>(solid.body_size()), 0.0);
  if (solid.damping_ratio() == 0) return rates;
  for (int b = 0; b < solid.body_size(); ++b) {
    const double omega_squared = modal::lowest_of_body<dim>(solid, b, 1).omega_squared[0];
    require(omega_squared > 0,
            "solid.damping_ratio: solid.body.{} is free to move as a whole; hold it, or omit the damping", b);
    rates[static_cast<std::size_t>(b)] = 2 * solid.damping_ratio() * std::sqrt(omega_squared);
  }
  return rates;
}

template std::vector<double> damping_rates<2>(const v1::Solid&);
template std::vector<double> damping_rates<3>(const v1::Solid&);

}  // namespace cosurge
