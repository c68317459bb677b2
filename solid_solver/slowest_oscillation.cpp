#include "solid_solver/slowest_oscillation.hpp"

#include <algorithm>
#include <cmath>

#include "solid_solver/models/modal/modes.hpp"
#include "solid_solver/models/relocated_model.hpp"

namespace cosurge {
namespace {

/// omega^2 of the first mode that is not a rigid motion [1/s2]; 0 if there is none.
template <int dim>
double first_elastic(const Structure<dim>& structure, std::size_t b) {
  constexpr int rigid_motions = dim == 2 ? 3 : 6;
  for (const double omega_squared : modal::lowest_of_body(structure, b, rigid_motions + 1).omega_squared)
    if (omega_squared > 0) return omega_squared;
  return 0;
}

template <int dim>
double of_elements(const Structure<dim>& structure) {
  double highest = 0;
  for (std::size_t b = 0; b < structure.bodies.size(); ++b)
    highest = std::max(highest, first_elastic(structure, b));
  return std::sqrt(highest);
}

}  // namespace

template <int dim>
double slowest_oscillation(const Structure<dim>& structure, const SolidModel& model) {
  if (structure.template is<RigidParameters>()) return 0;
  if (structure.template is<SprungParameters<dim>>()) {
    double highest = 0;
    constexpr int all = 6;
    for (const NodalMode& mode : model.modes(all)) highest = std::max(highest, mode.omega_squared);
    return std::sqrt(highest);
  }
  const std::optional<Vec<dim>> origin = origin_near_bodies(structure);
  return of_elements(origin ? relocated(structure, *origin) : structure);
}

template double slowest_oscillation<2>(const Structure<2>&, const SolidModel&);
template double slowest_oscillation<3>(const Structure<3>&, const SolidModel&);

}  // namespace cosurge
