#include "fluid_solver/mps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "common/error.hpp"
#include "common/ordered_sum.hpp"
#include "fluid_solver/covered_walls.hpp"
#include "fluid_solver/operators.hpp"
#include "fluid_solver/surface_damping.hpp"

namespace cosurge::fluid {
namespace {

// Limit on the particle speed, as a multiple of the speed of a fall or of a wall.
constexpr double beyond_physical = 10;

// Factor on the tolerance when a step may be repeated: the scheme takes differences between loads.
constexpr double precise = 1e-2;

/// Layers behind the wall: as many as complete the Laplacian of a particle in the wall.
int dummy_layers(const v1::Fluid& fluid) { return static_cast<int>(std::ceil(fluid.re_laplacian())) - 1; }

template <int dim>
PoissonParameters<dim> poisson_parameters(const v1::Fluid& fluid, const Vec<dim>& gravity) {
  return {.spacing = fluid.spacing(),
          .re = fluid.re_laplacian() * fluid.spacing(),
          .density = fluid.density(),
          .compressibility = fluid.compressibility(),
          .gravity = gravity,
          .open_surface = fluid.source() == v1::Fluid::time_scale};
}

/// Default propagation speed: that of long waves, sqrt(g H), where H is the initial height of the water.
template <int dim>
double shallow_speed(const std::vector<Vec<dim>>& water, const Vec<dim>& gravity, double spacing) {
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const Vec<dim>& x : water) {
    const double level = -x.dot(gravity);  // g times the height
    lowest = std::min(lowest, level);
    highest = std::max(highest, level);
  }
  return std::sqrt(std::max(0.0, highest - lowest) + gravity.norm() * spacing);
}

}  // namespace

template <int dim>
Mps<dim>::Mps(const v1::Fluid& fluid, const v1::Solid* solid, const Vec<dim>& gravity)
    : parameters_(fluid),
      gravity_(gravity),
      reference_(reference_values<dim>(fluid.re_gradient() * fluid.spacing(), fluid.spacing())),
      walls_(fluid, dummy_layers(fluid), open_surface()),
      neighbors_(walls_.domain(), fluid.re_gradient() * fluid.spacing()),
      poisson_(poisson_parameters<dim>(fluid, gravity)),
      preconditioner_(make_preconditioner(fluid.pressure())) {
  std::vector<BodySites<dim>> sites;
  for (int b = 0; solid != nullptr && b < solid->body_size(); ++b)
    sites.emplace_back(from_case<dim>(shape_of(solid->body(b))), fluid.spacing());
  add_water(sites);
  propagation_speed_ = fluid.has_propagation_speed() ? fluid.propagation_speed()
                                                     : shallow_speed(particles_.x, gravity, fluid.spacing());
  walls_.add_to(particles_);
  first_body_id_ = particles_.size();
  const auto tank = from_case<dim>(fluid.tank());
  if (solid != nullptr) bodies_ = Bodies<dim>(*solid, tank, fluid.spacing());
  for (int k = 0; k < bodies_.points(); ++k) seen_.push_back(open_surface() ? bodies_.face_point(k) : k);
  for (int k = 0; k < bodies_.points(); ++k)
    particles_.add(bodies_.wet(k) ? Kind::body_surface : Kind::body_inner, bodies_.position(k));
  initial_size_ = particles_.size();
  // Jets of impacts reach two or three times the speed of a fall through the whole domain.
  const double fall = 2 * (tank.max - tank.min).maxCoeff();
  const double sound = 1 / std::sqrt(fluid.density() * fluid.compressibility());
  speed_bound_ = gravity.norm() > 0 ? beyond_physical * std::sqrt(2 * gravity.norm() * fall) : sound;
  const Box<dim> domain = walls_.domain();
  nowhere_ = domain.max + (domain.max - domain.min);
  search_neighbors(0);
  const Field at_rest = Field::Zero(dim, bodies_.points());
  move_bodies(at_rest, at_rest);
}

/// Fills the shapes of water; it gives way to obstacles and bodies, and where a shape is an outline also to
/// the tank and the shapes before it. (Boxes that overlap are refused when the case is read.)
template <int dim>
void Mps<dim>::add_water(const std::vector<BodySites<dim>>& bodies) {
  std::vector<Shape<dim>> filled;
  const auto tank = from_case<dim>(parameters_.tank());
  const auto taken = [&](const Vec<dim>& x, const Shape<dim>& by) {
    const auto holds = [&](const auto& region) { return region.contains(x); };
    if (walls_.covers(x) || std::any_of(bodies.begin(), bodies.end(), holds)) return true;
    return !by.is_box() && (!tank.contains(x) || std::any_of(filled.begin(), filled.end(), holds));
  };
  for (const v1::Shape& water : parameters_.water()) {
    const auto shape = from_case<dim>(water);
    for (const Vec<dim>& x : shape.fill(parameters_.spacing()))
      if (!taken(x, shape)) particles_.add(Kind::fluid, x);
    filled.push_back(shape);
  }
  require(particles_.size() > 0,
          "fluid.water: contains no particle; it is smaller than fluid.spacing, or lies outside the tank or "
          "in obstacles and bodies");
}

template <int dim>
StepReport Mps<dim>::step(double start, double dt, std::uint32_t attempt) {
  if (attempt <= 1)
    advance_to_pressure(start, dt);
  else
    return_to_pressure();
  if (attempt == 1) {
    predicted_x_ = particles_.x;
    predicted_u_ = particles_.u;
  }
  if (attempt <= 1) assemble(dt);
  set_source(dt);
  const SolveReport pressure = solve_pressure(start, dt, attempt);
  correct(dt);  // u = u* - dt / rho grad p, x = x* + dt (u - u*)
  if (parameters_.shifting() > 0) shift(dt);
  StepReport report = survey(start + dt, dt);
  report.pressure = pressure;
  clock_.leave();
  return report;
}

template <int dim>
void Mps<dim>::advance_to_pressure(double start, double dt) {
  predict(start, dt);  // u* = u + dt g, x* = x + dt u*; walls go to where they are at the end
  search_neighbors(start + dt);
  find_free_surface();
  diffuse_and_collide(dt);  // u* += dt nu lap u*, collisions and damping at the surface
}

/// The source `time_scale` has an OpenSurface. The others mend every divergence at once, which makes
/// particles of a surface with pressure separate: they use P = 0 on flagged particles, as Amaro & Cheng.
template <int dim>
void Mps<dim>::find_free_surface() {
  if (open_surface()) return density_and_lone_particles(particles_, neighbors_);
  density_and_free_surface(particles_, neighbors_, reference_.n0,
                           {.beta = parameters_.free_surface().beta(),
                            .delta = parameters_.free_surface().delta() * parameters_.spacing()});
}

template <int dim>
void Mps<dim>::return_to_pressure() {
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid) continue;
    particles_.x[i] = predicted_x_[i];
    particles_.u[i] = predicted_u_[i];
  }
}

template <int dim>
void Mps<dim>::predict(double start, double dt) {
  clock_.enter(predicting);
  if (may_cover()) walls_.move(particles_, start + dt, dt);
  speed_bound_ = std::max(speed_bound_, beyond_physical * walls_.speed());
  walls_.require_room(start + dt);
#pragma omp parallel for schedule(static)
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid) continue;
    particles_.u[i] += dt * gravity_;
    particles_.x[i] += dt * particles_.u[i];
  }
}

/// Sorts and lists; particles that have passed through a wall are first moved out of the domain, which
/// removes them.
template <int dim>
void Mps<dim>::search_neighbors(double time) {
  clock_.enter(searching);
  for (int i = 0; i < particles_.size(); ++i)
    if (particles_.kind[i] == Kind::fluid && walls_.outside(particles_.x[i], time))
      particles_.x[i] = nowhere_;
  for (int i = 0; i < particles_.size(); ++i)
    if (particles_.kind[i] == Kind::body_inner && bodies_.wet(particles_.id[i] - first_body_id_))
      particles_.kind[i] = Kind::body_surface;
  neighbors_.rebuild(particles_);
  locate_bodies();
  close_covered_faces();
  if (may_cover()) covers_ = cover_walls(particles_, neighbors_, walls_, parameters_.spacing());
  if (!open_surface()) covers_.clear();  // eq. (10) has walls at rest there
  follow_covers(particles_, covers_);
}

/// With flagged surfaces collisions have a restitution; with an open surface they are plastic.
template <int dim>
double Mps<dim>::restitution() const {
  const v1::Collision& collision = parameters_.collision();
  if (collision.has_restitution()) return collision.restitution();
  return open_surface() ? 0 : 0.2;
}

template <int dim>
void Mps<dim>::diffuse_and_collide(double dt) {
  clock_.enter(evaluating);
  const CollisionLaw law{.distance = parameters_.collision().distance() * parameters_.spacing(),
                         .restitution = restitution(),
                         .spacing = parameters_.spacing()};
  const double nu = parameters_.kinematic_viscosity();
  const SurfaceDamping damping =
      surface_damping(reference_.n0, propagation_speed_, parameters_.spacing(), dt);
  change_.assign(static_cast<std::size_t>(particles_.size()), Vec<dim>::Zero());
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid) continue;
    change_[i] = collision(particles_, neighbors_, i, law);
    if (open_surface()) change_[i] += damp_surface(particles_, neighbors_, i, reference_.n0, damping);
    if (nu > 0)
      change_[i] +=
          dt * nu * velocity_laplacian(particles_, neighbors_, i, reference_.n0, reference_.lambda0);
  }
  for (int i = 0; i < particles_.size(); ++i) particles_.u[i] += change_[i];
}

template <int dim>
void Mps<dim>::assemble(double dt) {
  clock_.enter(assembling);
  poisson_.assemble(particles_, neighbors_.grid(), areas_, response_time(dt));
  const auto& unknowns = poisson_.unknowns();
  pressure_.resize(unknowns.size());
  for (std::size_t k = 0; k < unknowns.size(); ++k) pressure_[k] = particles_.p[unknowns[k]];  // warm start
  set_source_per_divergence(dt);
  clock_.enter(solving);
  if (!unknowns.empty()) preconditioner_->set_up(poisson_.matrix(), poisson_.cells());
}

template <int dim>
SolveReport Mps<dim>::solve_pressure(double start, double dt, std::uint32_t attempt) {
  clock_.enter(solving);
  const auto& unknowns = poisson_.unknowns();
  const v1::Pressure& choice = parameters_.pressure();
  const double tolerance = (attempt > 0 ? precise : 1) * choice.tolerance();
  SolveReport report;
  if (!unknowns.empty()) {
    report = conjugate_gradient(poisson_.matrix(), poisson_.right_hand_side(), *preconditioner_, tolerance,
                                choice.max_iterations(), pressure_);
  }
  if (!report.converged)
    throw NumericalError(
        fmt::format("pressure: residual {:.2e} > {:.2e} after {} iterations at t = {:.6g} s; raise "
                    "fluid.pressure.max_iterations or lower time.window",
                    report.relative_residual, tolerance, report.iterations, start));
  take_pressure();
  set_face_load();
  added_mass_.couple({.bodies = bodies_in_water(),
                      .body_areas = faces_.area,
                      .face_load = face_load_,
                      .preconditioner = *preconditioner_,
                      .source_per_divergence = source_per_divergence_,
                      .least_per_change = least_per_change(dt),
                      .dt = dt,
                      .attempt = attempt,
                      .tolerance = tolerance,
                      .lowest_pressure = parameters_.lowest_pressure()},
                     pressure_);
  take_pressure();
  add_answer_of_modes();
  return report;
}

/// Gives the particles the pressures that were solved for.
template <int dim>
void Mps<dim>::take_pressure() {
  const auto& unknowns = poisson_.unknowns();
  std::fill(particles_.p.begin(), particles_.p.end(), 0.0);
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    particles_.p[unknowns[k]] = std::max(parameters_.lowest_pressure(), pressure_[k]);
}

template <int dim>
Vec<dim> Mps<dim>::pressure_gradient(int i) const {
  switch (parameters_.gradient()) {
    case v1::Fluid::p_min:
      return gradient_p_min(particles_, neighbors_, i, reference_.n0);
    case v1::Fluid::conserving:
      return gradient_conserving<dim>(particles_, neighbors_, i, reference_.n0,
                                      parameters_.density() * gravity_, parameters_.lowest_pressure());
    case v1::Fluid::corrected:
      return gradient_corrected(particles_, neighbors_, i, reference_.n0) +
             repulsion(particles_, neighbors_, i, reference_.n0);
  }
  return Vec<dim>::Zero();
}

template <int dim>
void Mps<dim>::correct(double dt) {
  clock_.enter(correcting);
  const double step = dt / parameters_.density();
  push_.resize(static_cast<std::size_t>(particles_.size()));
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int i = 0; i < particles_.size(); ++i)
    if (particles_.kind[i] == Kind::fluid) push_[i] = -step * pressure_gradient(i);
#pragma omp parallel for schedule(static)
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid) continue;
    particles_.u[i] += push_[i];
    particles_.x[i] += dt * (change_[i] + push_[i]);
  }
}

/// Moves inner particles away from where they crowd, eq. (18); velocities stay.
template <int dim>
void Mps<dim>::shift(double dt) {
  double fastest = 0;
  for (int i = 0; i < particles_.size(); ++i)
    if (particles_.kind[i] == Kind::fluid) fastest = std::max(fastest, particles_.u[i].norm());
  const double scale = parameters_.shifting() * std::min(fastest * dt, parameters_.spacing());
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int i = 0; i < particles_.size(); ++i)
    if (particles_.kind[i] == Kind::fluid)
      push_[i] = scale * even_out(particles_, neighbors_, i, reference_.n0);
#pragma omp parallel for schedule(static)
  for (int i = 0; i < particles_.size(); ++i)
    if (particles_.kind[i] == Kind::fluid) particles_.x[i] += push_[i];
}

template class Mps<2>;
template class Mps<3>;

}  // namespace cosurge::fluid
