// The water of a case: the only place where the fluid solver reads one.
#pragma once

#include <vector>

#include "fluid_solver/probe.hpp"
#include "fluid_solver/water.hpp"
#include "proto/case.pb.h"

namespace cosurge::fluid {

/// The water of a case, with its tank, obstacles and method. `gravity` [m/s2].
template <int dim>
Water<dim> water_from_case(const v1::Fluid& fluid, const Vec<dim>& gravity);

/// The bodies of all structures of a case, as the water needs them.
template <int dim>
std::vector<WetBody<dim>> bodies_from_case(const v1::Case& the_case);

/// The probes of the water, those of displacements left out.
template <int dim>
std::vector<Probe<dim>> probes_from_case(const v1::Case& the_case);

}  // namespace cosurge::fluid
