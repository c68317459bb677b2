// Creates the structural model that a case selects.
#pragma once

#include <memory>

#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// @throws Error for a structure that the model does not support.
template <int dim>
std::unique_ptr<SolidModel> make_model(const Structure<dim>& structure);

}  // namespace cosurge
