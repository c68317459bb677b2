// The parts of the fluid solver, made of messages of a case.
#pragma once

#include "fluid_solver/from_case.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid::test {

/// @param solid the structure; null: none
template <int dim>
Mps<dim> mps_of(const v1::Fluid& fluid, const v1::Solid* solid, const Vec<dim>& gravity) {
  return Mps<dim>(water_from_case(fluid, gravity),
                  solid != nullptr ? bodies_from_case<dim>(*solid) : std::vector<WetBody<dim>>());
}

/// The structure as the fluid meets it.
template <int dim>
Bodies<dim> bodies_of(const v1::Solid& solid, const Box<dim>& tank, double spacing) {
  return Bodies<dim>(bodies_from_case<dim>(solid), tank, spacing);
}

}  // namespace cosurge::fluid::test
