#include "solid_solver/models/make_model.hpp"

#include "common/error.hpp"
#include "common/geometry/body_sites.hpp"
#include "common/vec.hpp"
#include "solid_solver/models/fem/fem_model.hpp"
#include "solid_solver/models/hamiltonian/hamiltonian_body.hpp"
#include "solid_solver/models/modal/modal_model.hpp"
#include "solid_solver/models/mps/mps_body.hpp"
#include "solid_solver/models/relocated_model.hpp"
#include "solid_solver/models/rigid/rigid_model.hpp"
#include "solid_solver/models/sprung/sprung_model.hpp"

namespace cosurge {
namespace {

template <int dim>
Vec<dim> gravity_of(const v1::Case& the_case) {
  if (the_case.gravity_size() == 0) return Vec<dim>::Zero();
  return Eigen::Map<const Vec<dim>>(the_case.gravity().data());
}

template <int dim>
std::unique_ptr<SolidModel> make(const v1::Case& the_case) {
  const v1::Solid& solid = the_case.solid();
  const double spacing = solid_spacing(the_case);
  const Vec<dim> gravity = gravity_of<dim>(the_case);
  switch (solid.model()) {
    case v1::SolidModel::mps:
      return mps::make_mps<dim>(solid, spacing, gravity);
    case v1::SolidModel::hamiltonian:
      return hamiltonian::make_hamiltonian<dim>(solid, spacing, gravity);
    case v1::SolidModel::fem:
      return std::make_unique<fem::FemModel<dim>>(solid, spacing, gravity);
    case v1::SolidModel::modal:
      return std::make_unique<modal::ModalModel<dim>>(solid, spacing, gravity);
    case v1::SolidModel::rigid:
      return std::make_unique<RigidModel<dim>>(solid, spacing);
    case v1::SolidModel::sprung:
      return std::make_unique<sprung::SprungModel<dim>>(solid, spacing, gravity);
  }
  throw Error("solid.model: unknown");
}

}  // namespace

std::unique_ptr<SolidModel> make_model(const v1::Case& the_case) {
  require(the_case.has_solid(), "the case has no solid");
  const auto model = the_case.solid().model();
  const bool deformable = model != v1::SolidModel::rigid && model != v1::SolidModel::sprung;
  require(!deformable || the_case.solid().has_young_modulus(),
          "solid.young_modulus: missing, the model {} needs it", v1::SolidModel::Word_Name(model));
  const auto made = [](const v1::Case& c) { return c.dimension() == 2 ? make<2>(c) : make<3>(c); };
  const std::vector<double> origin = origin_near_bodies(the_case, solid_spacing(the_case));
  if (origin.empty()) return made(the_case);
  return saying_origin(origin, [&]() -> std::unique_ptr<SolidModel> {
    return std::make_unique<RelocatedModel>(made(relocated(the_case, origin)), origin);
  });
}

}  // namespace cosurge
