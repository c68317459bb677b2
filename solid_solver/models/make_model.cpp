#include "solid_solver/models/make_model.hpp"

#include "solid_solver/models/automatic/automatic_model.hpp"
#include "solid_solver/models/fem/fem_model.hpp"
#include "solid_solver/models/hamiltonian/hamiltonian_body.hpp"
#include "solid_solver/models/modal/modal_model.hpp"
#include "solid_solver/models/mps/mps_body.hpp"
#include "solid_solver/models/relocated_model.hpp"
#include "solid_solver/models/rigid/rigid_model.hpp"
#include "solid_solver/models/sprung/sprung_model.hpp"

namespace cosurge {
namespace {

/// Creates the model of the alternative that Structure::model holds.
template <int dim>
struct Maker {
  const Structure<dim>& structure;

  using Made = std::unique_ptr<SolidModel>;
  Made operator()(const MpsParameters& mps) const { return mps::make_mps(structure, mps); }
  Made operator()(const HamiltonianParameters& hamiltonian) const {
    return hamiltonian::make_hamiltonian(structure, hamiltonian);
  }
  Made operator()(const FemParameters& fem) const {
    return std::make_unique<fem::FemModel<dim>>(structure, fem);
  }
  Made operator()(const ModalParameters& modal) const {
    return std::make_unique<modal::ModalModel<dim>>(structure, modal);
  }
  Made operator()(const AutomaticParameters& automatic) const {
    return std::make_unique<automatic::AutomaticModel<dim>>(structure, automatic);
  }
  Made operator()(const RigidParameters&) const { return std::make_unique<RigidModel<dim>>(structure); }
  Made operator()(const SprungParameters<dim>& sprung) const {
    return std::make_unique<sprung::SprungModel<dim>>(structure, sprung);
  }
};

template <int dim>
std::unique_ptr<SolidModel> made(const Structure<dim>& structure) {
  return std::visit(Maker<dim>{structure}, structure.model);
}

}  // namespace

template <int dim>
std::unique_ptr<SolidModel> make_model(const Structure<dim>& structure) {
  const std::optional<Vec<dim>> origin = origin_near_bodies(structure);
  if (!origin) return made(structure);
  return saying_origin(*origin, [&]() -> std::unique_ptr<SolidModel> {
    return std::make_unique<RelocatedModel>(made(relocated(structure, *origin)), *origin);
  });
}

template std::unique_ptr<SolidModel> make_model<2>(const Structure<2>&);
template std::unique_ptr<SolidModel> make_model<3>(const Structure<3>&);

}  // namespace cosurge
