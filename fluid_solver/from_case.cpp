#include "fluid_solver/from_case.hpp"

#include "common/case/bodies.hpp"
#include "common/case/carriers.hpp"
#include "common/case/from_case.hpp"
#include "common/case/probe_columns.hpp"
#include "common/case/probe_mount.hpp"
#include "common/case/window_sizes.hpp"
#include "common/error.hpp"

namespace cosurge::fluid {
namespace {

Source source_from_case(v1::Fluid::Source source) {
  switch (source) {
    case v1::Fluid::deviation:
      return Source::deviation;
    case v1::Fluid::mixed:
      return Source::mixed;
    case v1::Fluid::time_scale:
      return Source::time_scale;
  }
  throw Error("fluid.source: unknown");
}

Gradient gradient_from_case(v1::Fluid::Gradient gradient) {
  switch (gradient) {
    case v1::Fluid::p_min:
      return Gradient::p_min;
    case v1::Fluid::conserving:
      return Gradient::conserving;
    case v1::Fluid::corrected:
      return Gradient::corrected;
  }
  throw Error("fluid.gradient: unknown");
}

PressureSolution pressure_from_case(const v1::Pressure& pressure) {
  using Preconditioner = PressureSolution::Preconditioner;
  return {.preconditioner = pressure.preconditioner() == v1::Pressure::jacobi ? Preconditioner::jacobi
                                                                              : Preconditioner::aggregation,
          .tolerance = pressure.tolerance(),
          .max_iterations = pressure.max_iterations()};
}

Method method_from_case(const v1::Fluid& fluid) {
  Method method{.source = source_from_case(fluid.source()),
                .gradient = gradient_from_case(fluid.gradient()),
                .gamma = fluid.gamma(),
                .propagation_speed = {},
                .re_gradient = fluid.re_gradient(),
                .re_laplacian = fluid.re_laplacian(),
                .courant = courant_number(fluid, false),
                .courant_driven = courant_number(fluid, true),
                .shifting = fluid.shifting(),
                .lowest_pressure = fluid.lowest_pressure(),
                .free_surface = {.beta = fluid.free_surface().beta(), .delta = fluid.free_surface().delta()},
                .collision = {.distance = fluid.collision().distance(), .restitution = {}},
                .pressure = pressure_from_case(fluid.pressure())};
  if (fluid.has_propagation_speed()) method.propagation_speed = fluid.propagation_speed();
  if (fluid.collision().has_restitution()) method.collision.restitution = fluid.collision().restitution();
  return method;
}

Quantity quantity_from_case(v1::Probe::Quantity quantity) {
  switch (quantity) {
    case v1::Probe::pressure:
      return Quantity::pressure;
    case v1::Probe::level:
      return Quantity::level;
    case v1::Probe::force:
      return Quantity::force;
    case v1::Probe::moment:
      return Quantity::moment;
    case v1::Probe::displacement:
      break;
  }
  throw Error("output.probe: not a quantity of the water");
}

}  // namespace

template <int dim>
Water<dim> water_from_case(const v1::Fluid& fluid, const Vec<dim>& gravity) {
  Water<dim> water{.spacing = fluid.spacing(),
                   .density = fluid.density(),
                   .kinematic_viscosity = fluid.kinematic_viscosity(),
                   .compressibility = fluid.compressibility(),
                   .gravity = gravity,
                   .tank = tank_from_case<dim>(fluid),
                   .obstacles = obstacles_from_case<dim>(fluid),
                   .regions = {},
                   .most_lost = fluid.most_lost(),
                   .method = method_from_case(fluid)};
  for (const v1::Shape& region : fluid.water()) water.regions.push_back(from_case<dim>(region));
  return water;
}

template <int dim>
std::vector<WetBody<dim>> bodies_from_case(const v1::Case& the_case) {
  std::vector<WetBody<dim>> bodies;
  for (const v1::Body& body : the_case.solid().body()) {
    bodies.push_back({.shape = from_case<dim>(shape_of(body)),
                      .clamps = {},
                      .held_at_rest = is_held_at_rest(the_case, body)});
    for (const v1::Shape& clamp : body.clamp()) bodies.back().clamps.push_back(from_case<dim>(clamp));
  }
  return bodies;
}

template <int dim>
std::vector<Probe<dim>> probes_from_case(const v1::Case& the_case) {
  std::vector<Probe<dim>> probes;
  for (const v1::Probe& probe : the_case.output().probe())
    if (probe.quantity() != v1::Probe::displacement)
      probes.push_back({.name = probe.name(),
                        .quantity = quantity_from_case(probe.quantity()),
                        .position = from_case<dim>(probe.position()),
                        .mount = mount_of(the_case, probe),
                        .columns = probe_columns(probe, dim)});
  return probes;
}

template Water<2> water_from_case<2>(const v1::Fluid&, const Vec<2>&);
template Water<3> water_from_case<3>(const v1::Fluid&, const Vec<3>&);
template std::vector<WetBody<2>> bodies_from_case<2>(const v1::Case&);
template std::vector<WetBody<3>> bodies_from_case<3>(const v1::Case&);
template std::vector<Probe<2>> probes_from_case<2>(const v1::Case&);
template std::vector<Probe<3>> probes_from_case<3>(const v1::Case&);

}  // namespace cosurge::fluid
