#include "solid_solver/models/make_model.hpp"

#include "common/error.hpp"
#include "common/vec.hpp"
#include "solid_solver/models/fem/fem_model.hpp"
#include "solid_solver/models/modal/modal_model.hpp"
#include "solid_solver/models/mps/mps_model.hpp"
#include "solid_solver/models/rigid/rigid_model.hpp"

namespace cosurge {
namespace {

double spacing_of(const v1::Case& the_case) {
  if (the_case.solid().has_spacing()) return the_case.solid().spacing();
  require(the_case.has_fluid(), "solid.spacing: missing, and there is no fluid to take it from");
  return the_case.fluid().spacing();
}

template <int dim>
Vec<dim> gravity_of(const v1::Case& the_case) {
  if (the_case.gravity_size() == 0) return Vec<dim>::Zero();
  return Eigen::Map<const Vec<dim>>(the_case.gravity().data());
}

template <int dim>
std::unique_ptr<SolidModel> make(const v1::Case& the_case) {
  const v1::Solid& solid = the_case.solid();
  switch (solid.model()) {
    case v1::SolidModel::mps:
      return std::make_unique<mps::MpsModel<dim>>(solid, spacing_of(the_case), gravity_of<dim>(the_case));
    case v1::SolidModel::rigid:
      return std::make_unique<RigidModel<dim>>(solid, spacing_of(the_case));
    case v1::SolidModel::fem:
      return std::make_unique<fem::FemModel<dim>>(solid, spacing_of(the_case), gravity_of<dim>(the_case));
    case v1::SolidModel::modal:
      return std::make_unique<modal::ModalModel<dim>>(solid, spacing_of(the_case), gravity_of<dim>(the_case));
  }
  throw Error("solid.model: unknown");
}

}  // namespace

std::unique_ptr<SolidModel> make_model(const v1::Case& the_case) {
  require(the_case.has_solid(), "the case has no solid");
  require(the_case.dimension() == 2, "dimension = {}: the solid solver computes scenes of 2 dimensions",
          the_case.dimension());
  return make<2>(the_case);
}

}  // namespace cosurge
