#include "fluid_solver/mps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
int dummy_layers(const Method& method) { return static_cast<int>(std::ceil(method.re_laplacian)) - 1; }

template <int dim>
PoissonParameters<dim> poisson_parameters(const Water<dim>& water) {
  return {.spacing = water.spacing,
          .re = water.method.re_laplacian * water.spacing,
          .density = water.density,
          .compressibility = water.compressibility,
          .gravity = water.gravity,
          .open_surface = water.method.source == Source::time_scale};
}

/// Default propagation speed: that of long waves, sqrt(g H), with the initial height H of the water.
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
Mps<dim>::Mps(const Water<dim>& water, const std::vector<WetBody<dim>>& bodies)
    : water_(water),
      reference_(reference_values<dim>(water.method.re_gradient * water.spacing, water.spacing)),
      walls_(water, dummy_layers(water.method), open_surface()),
      neighbors_(walls_.domain(), water.method.re_gradient * water.spacing),
      poisson_(poisson_parameters(water)),
      preconditioner_(make_preconditioner(water.method.pressure.preconditioner)) {
  add_water(bodies);
  propagation_speed_ = water.method.propagation_speed
                           ? *water.method.propagation_speed
                           : shallow_speed(particles_.x, water.gravity, water.spacing);
  walls_.add_to(particles_);
  first_body_id_ = particles_.size();
  const Box<dim>& tank = water.tank.box;
  bodies_ = Bodies<dim>(bodies, tank, water.spacing);
  for (int k = 0; k < bodies_.points(); ++k) seen_.push_back(open_surface() ? bodies_.face_point(k) : k);
  for (int k = 0; k < bodies_.points(); ++k)
    particles_.add(bodies_.wet(k) ? Kind::body_surface : Kind::body_inner, bodies_.position(k));
  initial_size_ = particles_.size();
  // Jets of impacts reach two or three times the speed of a fall through the whole domain.
  const double fall = 2 * (tank.max - tank.min).maxCoeff();
  const double sound = 1 / std::sqrt(water.density * water.compressibility);
  const double gravity = water.gravity.norm();
  speed_bound_ = gravity > 0 ? beyond_physical * std::sqrt(2 * gravity * fall) : sound;
  const Box<dim> domain = walls_.domain();
  nowhere_ = domain.max + (domain.max - domain.min);
  search_neighbors(0);
  const Field at_rest = Field::Zero(dim, bodies_.points());
  move_bodies(at_rest, at_rest);
}

/// Fills the regions of water with particles, except sites in obstacles and bodies. A region given as an
/// outline also leaves out sites outside the tank and in earlier regions; for boxes the case rules exclude
/// both.
template <int dim>
void Mps<dim>::add_water(const std::vector<WetBody<dim>>& bodies) {
  std::vector<BodySites<dim>> sites;
  for (const WetBody<dim>& body : bodies) sites.emplace_back(body.shape, water_.spacing);
  std::vector<Shape<dim>> filled;
  const auto taken = [&](const Vec<dim>& x, const Shape<dim>& by) {
    const auto holds = [&](const auto& region) { return region.contains(x); };
    if (walls_.covers(x) || std::any_of(sites.begin(), sites.end(), holds)) return true;
    return !by.is_box() && (!water_.tank.box.contains(x) || std::any_of(filled.begin(), filled.end(), holds));
  };
  for (const Shape<dim>& region : water_.regions) {
    for (const Vec<dim>& x : region.fill(water_.spacing))
      if (!taken(x, region)) particles_.add(Kind::fluid, x);
    filled.push_back(region);
  }
  require(particles_.size() > 0,
          "fluid.water: contains no particle; it is smaller than fluid.spacing, or lies outside the tank or "
          "in obstacles and bodies");
}

template <int dim>
StepReport Mps<dim>::step(double start, double dt, Attempt attempt) {
  const bool repeated = attempt == Attempt::again;
  if (repeated)
    return_to_pressure();
  else
    advance_to_pressure(start, dt);
  if (attempt == Attempt::first) {
    predicted_x_ = particles_.x;
    predicted_u_ = particles_.u;
  }
  if (!repeated) assemble(dt);
  set_source(dt);
  const SolveReport pressure = solve_pressure(start, dt, attempt);
  correct(dt);  // u = u* - dt / rho grad p, x = x* + dt (u - u*)
  if (water_.method.shifting > 0) shift(dt);
  StepReport report = survey(start + dt, dt);
  report.pressure = pressure;
  clock_.leave();
  return report;
}

template <int dim>
void Mps<dim>::advance_to_pressure(double start, double dt) {
  predict(start, dt);  // u* = u + dt g, x* = x + dt u*; walls go to where they are at the end
  search_neighbors(start + dt);
  find_driven_speed(start + dt, dt);
  find_free_surface();
  diffuse_and_collide(dt);  // u* += dt nu lap u*, collisions and damping at the surface
}

/// Only the source `time_scale` uses an OpenSurface. The other sources correct the whole divergence in one
/// step, so that particles of a surface with pressure would separate; they set P = 0 on flagged particles, as
/// Amaro & Cheng.
template <int dim>
void Mps<dim>::find_free_surface() {
  if (open_surface()) {
    smooth_density_ = density_and_lone_particles(particles_, neighbors_);
    return;
  }
  density_and_free_surface(
      particles_, neighbors_, reference_.n0,
      {.beta = water_.method.free_surface.beta, .delta = water_.method.free_surface.delta * water_.spacing});
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
  speed_bound_ = std::max(speed_bound_, beyond_physical * std::max(walls_.speed(), max_body_speed_));
  walls_.require_room(start + dt);
#pragma omp parallel for schedule(static)
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid) continue;
    particles_.u[i] += dt * water_.gravity;
    particles_.x[i] += dt * particles_.u[i];
  }
}

/// Sorts the particles and lists their neighbours. Particles that have passed through a wall are first moved
/// out of the domain, which removes them.
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
  if (may_cover()) covers_ = cover_walls(particles_, neighbors_, walls_, water_.spacing);
  if (!open_surface()) covers_.clear();  // eq. (10) treats covered walls as walls at rest
  follow_covers(particles_, covers_);
}

/// Coefficient of restitution: by default 0 with an open surface and 0.2 with flagged surfaces.
template <int dim>
double Mps<dim>::restitution() const {
  return water_.method.collision.restitution.value_or(open_surface() ? 0 : 0.2);
}

template <int dim>
void Mps<dim>::diffuse_and_collide(double dt) {
  clock_.enter(evaluating);
  const CollisionLaw law{.distance = water_.method.collision.distance * water_.spacing,
                         .restitution = restitution(),
                         .spacing = water_.spacing};
  const double nu = water_.kinematic_viscosity;
  const Vec<dim> kick = dt * water_.gravity;
  const SurfaceDamping damping = surface_damping(reference_.n0, propagation_speed_, water_.spacing, dt);
  change_.assign(static_cast<std::size_t>(particles_.size()), Vec<dim>::Zero());
  direct_force_.clear(particles_.size());
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid) continue;
    change_[i] = collision(particles_, neighbors_, i, law,
                           [&](int, const Vec<dim>&) { direct_force_.note_struck(i); });
    if (open_surface()) change_[i] += damp_surface(particles_, neighbors_, i, reference_.n0, damping);
    if (nu == 0) continue;
    const FaceBefore<dim> face = face_before(particles_, neighbors_, i, water_.spacing);
    if (face.place >= 0) direct_force_.note_rubbing(i);
    change_[i] +=
        dt * nu *
        velocity_laplacian(particles_, neighbors_, i, face, kick, reference_.n0, reference_.lambda0);
  }
  const double mass = water_.density * std::pow(water_.spacing, dim);
  direct_force_.add_collisions(particles_, neighbors_, law, mass, dt);
  if (nu > 0)
    direct_force_.add_friction(particles_, neighbors_, water_.spacing, kick,
                               mass * nu * 2 * dim / (reference_.lambda0 * reference_.n0));
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
SolveReport Mps<dim>::solve_pressure(double start, double dt, Attempt attempt) {
  clock_.enter(solving);
  const auto& unknowns = poisson_.unknowns();
  const PressureSolution& choice = water_.method.pressure;
  const double tolerance = (attempt == Attempt::once ? 1 : precise) * choice.tolerance;
  SolveReport report;
  if (!unknowns.empty()) {
    report = conjugate_gradient(poisson_.matrix(), poisson_.right_hand_side(), *preconditioner_, tolerance,
                                choice.max_iterations, pressure_);
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
                      .lowest_pressure = water_.method.lowest_pressure},
                     pressure_);
  take_pressure();
  film_pressure_.solve(bodies_, body_place_, particles_, slope_to_faces(), water_.spacing);
  add_answer_of_modes();
  return report;
}

/// Gives the particles the pressures that were solved for.
template <int dim>
void Mps<dim>::take_pressure() {
  const auto& unknowns = poisson_.unknowns();
  std::fill(particles_.p.begin(), particles_.p.end(), 0.0);
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    particles_.p[unknowns[k]] = std::max(water_.method.lowest_pressure, pressure_[k]);
}

template <int dim>
Vec<dim> Mps<dim>::pressure_gradient(int i) const {
  switch (water_.method.gradient) {
    case Gradient::p_min:
      return gradient_p_min(particles_, neighbors_, i, reference_.n0);
    case Gradient::conserving:
      return gradient_conserving<dim>(particles_, neighbors_, i, reference_.n0,
                                      water_.density * water_.gravity, water_.method.lowest_pressure);
    case Gradient::corrected: {
      const auto [gradient, repulsion] = gradient_corrected(particles_, neighbors_, i, reference_.n0);
      return gradient + repulsion;
    }
  }
  return Vec<dim>::Zero();
}

template <int dim>
void Mps<dim>::correct(double dt) {
  clock_.enter(correcting);
  const double step = dt / water_.density;
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

/// Moves inner particles towards even spacing, eq. (18); velocities are not changed.
template <int dim>
void Mps<dim>::shift(double dt) {
  double fastest = 0;
  for (int i = 0; i < particles_.size(); ++i)
    if (particles_.kind[i] == Kind::fluid) fastest = std::max(fastest, particles_.u[i].norm());
  const double scale = water_.method.shifting * std::min(fastest * dt, water_.spacing);
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
