// Velocities at the faces of walls and bodies, along which water slides.
#pragma once

#include "common/vec.hpp"

namespace cosurge::fluid {

/// The part of `velocity` across a face with the unit normal `n`; all of it where n is zero.
template <int dim>
Vec<dim> across_face(const Vec<dim>& velocity, const Vec<dim>& n) {
  return n.isZero() ? velocity : Vec<dim>(velocity.dot(n) * n);
}

/// The part of `velocity` along a face with the unit normal `n`.
template <int dim>
Vec<dim> along_face(const Vec<dim>& velocity, const Vec<dim>& n) {
  return velocity - velocity.dot(n) * n;
}

}  // namespace cosurge::fluid
