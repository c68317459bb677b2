#include "solid_solver/from_case.hpp"

#include "common/case/bodies.hpp"
#include "common/case/carriers.hpp"
#include "common/case/from_case.hpp"
#include "common/case/window_sizes.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

template <int dim>
Body<dim> body_from_case(const v1::Case& the_case, const v1::Body& body) {
  Body<dim> made{.shape = from_case<dim>(shape_of(body)),
                 .clamps = {},
                 .supports = {},
                 .held = is_held(the_case.solid(), body),
                 .carrier = from_case<dim>(motion_of(the_case, body)),
                 .velocity = Vec<dim>::Zero()};
  if (body.velocity_size() > 0) {
    const Vec<dim> velocity = from_case<dim>(body.velocity());
    if (the_case.solid().model() == v1::SolidModel::sprung)
      made.velocity = velocity;
    else
      made.carrier = Motion<dim>(velocity);
  }
  for (const v1::Shape& clamp : body.clamp()) made.clamps.push_back(from_case<dim>(clamp));
  for (const v1::Support& support : body.support()) {
    made.supports.push_back({.box = from_case<dim>(support.box()), .along = {}});
    Axes<dim>& along = made.supports.back().along;
    along.fill(support.along_size() == 0);
    for (const int axis : support.along()) along.at(static_cast<std::size_t>(axis)) = true;
  }
  return made;
}

template <typename Parameters>
ParticleParameters particles_from_case(const Parameters& parameters) {
  return {.re = parameters.re(),
          .step_fraction = parameters.step_fraction(),
          .substep = parameters.substep(),
          .viscosity = parameters.viscosity()};
}

template <int dim>
SprungParameters<dim> sprung_from_case(const v1::SolidSprung& sprung) {
  SprungParameters<dim> made;
  if (sprung.has_mass()) made.mass = sprung.mass();
  if (sprung.pivot_size() > 0) made.pivot = from_case<dim>(sprung.pivot());
  for (const v1::Spring& spring : sprung.spring()) {
    const Spring its{
        .stiffness = spring.stiffness(), .damping = spring.damping(), .preload = spring.preload()};
    if (spring.motion() <= v1::Spring::z)
      made.along.at(static_cast<std::size_t>(spring.motion())) = its;
    else
      made.turn.at(dim == 2 ? 0 : static_cast<std::size_t>(spring.motion() - v1::Spring::turn_x)) = its;
  }
  return made;
}

FemParameters fem_from_case(const v1::SolidFem& fem) {
  return {.rho_infinity = fem.rho_infinity(), .substep = fem.substep()};
}

ModalParameters modal_from_case(const v1::Solid& solid) {
  return {.modes = solid.modal().modes(), .rho_infinity = solid.fem().rho_infinity()};
}

template <int dim>
typename Structure<dim>::Model model_from_case(const v1::Solid& solid) {
  switch (solid.model()) {
    case v1::SolidModel::mps:
      return MpsParameters{.particles = particles_from_case(solid.mps()),
                           .pairs = solid.mps().pairs() == v1::SolidMps::paper
                                        ? MpsParameters::Pairs::paper
                                        : MpsParameters::Pairs::corrected};
    case v1::SolidModel::hamiltonian:
      return HamiltonianParameters{.particles = particles_from_case(solid.hamiltonian()),
                                   .stabilisation = solid.hamiltonian().stabilisation()};
    case v1::SolidModel::fem:
      return fem_from_case(solid.fem());
    case v1::SolidModel::modal:
      return modal_from_case(solid);
    case v1::SolidModel::auto_:
      return AutomaticParameters{.fem = fem_from_case(solid.fem()), .modal = modal_from_case(solid)};
    case v1::SolidModel::rigid:
      return RigidParameters{};
    case v1::SolidModel::sprung:
      return sprung_from_case<dim>(solid.sprung());
  }
  throw Error("solid.model: unknown");
}

/// Number of modes that the coupling scheme needs.
int modes_from_case(const v1::Coupling& coupling) {
  switch (coupling.scheme()) {
    case v1::Coupling::weak_inertial:
    case v1::Coupling::strong_inertial:
    case v1::Coupling::auto_:
      return coupling.modes();
    case v1::Coupling::weak:
    case v1::Coupling::strong:
      break;
  }
  return 0;
}

template <int dim>
DisplacementProbe<dim> probe_from_case(const v1::Probe& probe, const v1::Solid& solid) {
  const int body = body_at(solid, probe.position());
  require(body >= 0, "output.probe \"{}\": position ({}) lies in no body", probe.name(),
          fmt::join(probe.position(), ", "));
  return {.name = probe.name(), .position = from_case<dim>(probe.position()), .body = body};
}

}  // namespace

template <int dim>
Structure<dim> structure_from_case(const v1::Case& the_case) {
  require(the_case.has_solid(), "the case has no solid");
  const v1::Solid& solid = the_case.solid();
  const bool deformable = solid.model() != v1::SolidModel::rigid && solid.model() != v1::SolidModel::sprung;
  require(!deformable || solid.has_young_modulus(), "solid.young_modulus: missing, the model {} needs it",
          v1::SolidModel::Word_Name(solid.model()));
  Structure<dim> structure{.model = model_from_case<dim>(solid),
                           .spacing = solid_spacing(the_case),
                           .element = solid.fem().element(),
                           .material = {.density = solid.density(),
                                        .young_modulus = solid.young_modulus(),
                                        .poisson_ratio = solid.poisson_ratio(),
                                        .plane_stress = dim == 2 && solid.plane() == v1::Solid::plane_stress,
                                        .neo_hookean = solid.material() == v1::Solid::neo_hookean},
                           .damping_ratio = solid.damping_ratio(),
                           .gravity = from_case<dim>(the_case.gravity()),
                           .bodies = {}};
  for (const v1::Body& body : solid.body()) structure.bodies.push_back(body_from_case<dim>(the_case, body));
  return structure;
}

template <int dim>
Surroundings<dim> surroundings_from_case(const v1::Case& the_case) {
  const v1::Fluid& fluid = the_case.fluid();
  Surroundings<dim> surroundings{
      .tank = {}, .obstacles = obstacles_from_case<dim>(fluid), .window = expected_window(the_case)};
  if (fluid.has_tank()) surroundings.tank = tank_from_case<dim>(fluid);
  return surroundings;
}

template <int dim>
Scene<dim> scene_from_case(const v1::Case& the_case) {
  Scene<dim> scene{.structure = structure_from_case<dim>(the_case),
                   .surroundings = surroundings_from_case<dim>(the_case),
                   .exchange = {.ramped = the_case.coupling().load() == v1::Coupling::ramped,
                                .end_velocity = the_case.coupling().velocity() == v1::Coupling::end,
                                .modes = modes_from_case(the_case.coupling())},
                   .probes = {},
                   .limits_windows = !the_case.time().has_window()};
  for (const v1::Probe& probe : the_case.output().probe())
    if (probe.quantity() == v1::Probe::displacement)
      scene.probes.push_back(probe_from_case<dim>(probe, the_case.solid()));
  return scene;
}

template Structure<2> structure_from_case<2>(const v1::Case&);
template Structure<3> structure_from_case<3>(const v1::Case&);
template Surroundings<2> surroundings_from_case<2>(const v1::Case&);
template Surroundings<3> surroundings_from_case<3>(const v1::Case&);
template Scene<2> scene_from_case<2>(const v1::Case&);
template Scene<3> scene_from_case<3>(const v1::Case&);

}  // namespace cosurge
