// The parts of the fluid solver, made of messages of a case.
#pragma once

#include "fluid_solver/from_case.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid::test {

/// @param solid the structure; null: none
template <int dim>
Mps<dim> mps_of(const v1::Fluid& fluid, const v1::Solid* solid, const Vec<dim>& gravity) {
  v1::Case the_case;
  the_case.set_dimension(dim);
  *the_case.mutable_fluid() = fluid;
  if (solid != nullptr) *the_case.mutable_solid() = *solid;
  return Mps<dim>(water_from_case(fluid, gravity), bodies_from_case<dim>(the_case));
}

/// The structure as the fluid meets it.
template <int dim>
Bodies<dim> bodies_of(const v1::Solid& solid, const Box<dim>& tank, double spacing) {
  v1::Case the_case;
  the_case.set_dimension(dim);
  *the_case.mutable_solid() = solid;
  return Bodies<dim>(bodies_from_case<dim>(the_case), tank, spacing);
}

}  // namespace cosurge::fluid::test
