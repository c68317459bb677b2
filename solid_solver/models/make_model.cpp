#include "solid_solver/models/make_model.hpp"

#include "common/error.hpp"
#include "common/vec.hpp"
#include "solid_solver/models/fem/fem_model.hpp"
#include "solid_solver/models/hamiltonian/hamiltonian_body.hpp"
#include "solid_solver/models/modal/modal_model.hpp"
#include "solid_solver/models/mps/mps_body.hpp"
#include "solid_solver/models/rigid/rigid_model.hpp"
#include "solid_solver/models/sprung/sprung_model.hpp"

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
std::unique_ptr<SolidModel> make_rigid(const v1::Case& the_case) {
  const v1::Solid& solid = the_case.solid();
  if (solid.model() == v1::SolidModel::rigid)
    return std::make_unique<RigidModel<dim>>(solid, spacing_of(the_case));
  return std::make_unique<sprung::SprungModel<dim>>(solid, spacing_of(the_case), gravity_of<dim>(the_case));
}

std::unique_ptr<SolidModel> make_deformable(const v1::Case& the_case) {
  const v1::Solid& solid = the_case.solid();
  require(the_case.dimension() == 2, "dimension = {}: solid.model = \"{}\" is for scenes of 2 dimensions",
          the_case.dimension(), v1::SolidModel::Word_Name(solid.model()));
  require(solid.has_young_modulus(), "solid.young_modulus: missing");
  const double spacing = spacing_of(the_case);
  const Vec<2> gravity = gravity_of<2>(the_case);
  switch (solid.model()) {
    case v1::SolidModel::mps:
      return mps::make_mps(solid, spacing, gravity);
    case v1::SolidModel::hamiltonian:
      return hamiltonian::make_hamiltonian<2>(solid, spacing, gravity);
    case v1::SolidModel::fem:
      return std::make_unique<fem::FemModel<2>>(solid, spacing, gravity);
    case v1::SolidModel::modal:
      return std::make_unique<modal::ModalModel<2>>(solid, spacing, gravity);
    case v1::SolidModel::rigid:
    case v1::SolidModel::sprung:
      break;
  }
  throw Error("solid.model: unknown");
}

}  // namespace

std::unique_ptr<SolidModel> make_model(const v1::Case& the_case) {
  require(the_case.has_solid(), "the case has no solid");
  const auto model = the_case.solid().model();
  if (model != v1::SolidModel::rigid && model != v1::SolidModel::sprung) return make_deformable(the_case);
  return the_case.dimension() == 2 ? make_rigid<2>(the_case) : make_rigid<3>(the_case);
}

}  // namespace cosurge
