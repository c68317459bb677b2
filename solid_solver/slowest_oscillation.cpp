#include "solid_solver/slowest_oscillation.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/body_sites.hpp"
#include "common/vec.hpp"
#include "solid_solver/models/modal/modes.hpp"
#include "solid_solver/models/relocated_model.hpp"

namespace cosurge {
namespace {

/// omega^2 of the first mode that is no rigid motion [1/s2]; 0 where there is none.
template <int dim>
double first_elastic(const v1::Solid& solid, int b) {
  constexpr int rigid_motions = dim == 2 ? 3 : 6;
  for (const double omega_squared : modal::lowest_of_body<dim>(solid, b, rigid_motions + 1).omega_squared)
    if (omega_squared > 0) return omega_squared;
  return 0;
}

template <int dim>
double of_elements(const v1::Solid& solid) {
  double highest = 0;
  for (int b = 0; b < solid.body_size(); ++b) highest = std::max(highest, first_elastic<dim>(solid, b));
  return std::sqrt(highest);
}

}  // namespace

double slowest_oscillation(const v1::Case& the_case, const SolidModel& model) {
  const auto word = the_case.solid().model();
  if (word == v1::SolidModel::rigid) return 0;
  if (word == v1::SolidModel::sprung) {
    double highest = 0;
    constexpr int all = 6;
    for (const NodalMode& mode : model.modes(all)) highest = std::max(highest, mode.omega_squared);
    return std::sqrt(highest);
  }
  const std::vector<double> origin = origin_near_bodies(the_case, solid_spacing(the_case));
  const v1::Case near = origin.empty() ? the_case : relocated(the_case, origin);
  return the_case.dimension() == 2 ? of_elements<2>(near.solid()) : of_elements<3>(near.solid());
}

}  // namespace cosurge
