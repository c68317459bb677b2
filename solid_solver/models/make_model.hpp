// The one switch from a structure to its model.
#pragma once

#include <memory>

#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// @throws Error for what the model refuses.
template <int dim>
std::unique_ptr<SolidModel> make_model(const Structure<dim>& structure);

}  // namespace cosurge
