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

/// Whether the way [m] to a point, `r` long, leads behind the face of a body with this outward normal of any
/// length: it makes less than 60 degrees with the inward one.
template <int dim>
bool behind_face(const Vec<dim>& normal, const Vec<dim>& way, double r) {
  constexpr double facing_away = -0.5;
  return normal.dot(way) < facing_away * normal.norm() * r;
}

}  // namespace cosurge::fluid
