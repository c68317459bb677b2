// The scene of a case: the only place where the solid solver reads one.
#pragma once

#include "proto/case.pb.h"
#include "solid_solver/scene.hpp"

namespace cosurge {

/// @throws Error for a case without a structure, or with a deformable one without Young's modulus, for one
/// whose solid has no spacing of its own and no fluid to take it from, and for bodies whose clamps lie in
/// things that move differently.
template <int dim>
Structure<dim> structure_from_case(const v1::Case& the_case);

/// Tank, obstacles and expected window of a case, for contact and the choice of windows.
template <int dim>
Surroundings<dim> surroundings_from_case(const v1::Case& the_case);

/// @throws Error as structure_from_case(), and for a probe of a displacement that lies in no body.
template <int dim>
Scene<dim> scene_from_case(const v1::Case& the_case);

}  // namespace cosurge
