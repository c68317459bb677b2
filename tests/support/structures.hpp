// Structures, bodies and regions of a case as the solvers have them.
#pragma once

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "solid_solver/from_case.hpp"

namespace cosurge::test {

/// The structure of a solid, without anything around it.
template <int dim>
Structure<dim> structure_of(v1::Solid solid) {
  if (!solid.has_spacing()) solid.set_spacing(1);
  if (!solid.has_young_modulus()) solid.set_young_modulus(1);
  v1::Case c;
  c.set_dimension(dim);
  *c.mutable_solid() = solid;
  return structure_from_case<dim>(c);
}

template <int dim>
Body<dim> body_of(const v1::Body& body) {
  v1::Solid solid;
  *solid.add_body() = body;
  return structure_of<dim>(solid).bodies.front();
}

}  // namespace cosurge::test
