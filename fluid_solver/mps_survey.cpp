// How fast the water is after a step, and the next step that this allows.
#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/water_step.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {
namespace {

constexpr int loose = 3;  // neighbours up to which a particle flies freely and no longer limits the step

/// Largest flight of such a particle in a step [l0]. It has no more than a few particles of a wall within two
/// spacings, so it meets a wall in a later step, as water with more neighbours.
constexpr double free_flight = 1;

/// Largest Courant number of water that approaches a face: water that moves farther into one in a step is
/// jammed in it, and thrown out.
constexpr double towards_faces = 0.4;

}  // namespace

/// Checks that water is left and that the fastest particle, `which`, does not exceed the physical limit of
/// the speed. @throws NumericalError
template <int dim>
void Mps<dim>::check_bounds(int water, int which, double fastest, double end) const {
  if (water == 0)
    throw NumericalError(
        fmt::format("no water is left at t = {:.6g} s: all of it has left the domain; raise fluid.tank or "
                    "lower time.window",
                    end));
  if (!(fastest <= speed_bound_))
    throw NumericalError(
        fmt::format("fluid particle {} at ({:.4g}) moves at {:.4g} m/s at t = {:.6g} s; the physical limit "
                    "is {:.4g} m/s: the pressure is unstable; lower time.window or fluid.courant",
                    particles_.id[which], fmt::join(particles_.x[which], ", "), fastest, end, speed_bound_));
}

template <int dim>
double Mps<dim>::courant(double driven) const {
  return answers_to_walls * driven > propagation_speed_ ? water_.method.courant_driven
                                                        : water_.method.courant;
}

/// Largest speed at which water beside a face approaches it; particles slower than `least` are left out
/// [m/s].
template <int dim>
double Mps<dim>::approach_to_faces(double least) const {
  double fastest = 0;
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid || particles_.u[i].norm() < least) continue;
    neighbors_.each(particles_, i, [&](int j, const Vec<dim>&, double) {
      fastest = std::max(fastest, (particles_.u[j] - particles_.u[i]).dot(particles_.normal[j]));
    });
  }
  return fastest;
}

/// Finds the largest speeds and the next step that they allow.
template <int dim>
StepReport Mps<dim>::survey(double end, double dt) {
  double fastest = 0;  // largest speed [m/s]
  const double wall_speed = std::max(walls_.speed(), walls_.speed_between(end, end + dt));
  double fastest_bound = std::max(max_body_speed_, wall_speed);
  int which = -1;
  int water = 0;
  for (int i = 0; i < particles_.size(); ++i) {
    if (particles_.kind[i] != Kind::fluid) continue;
    ++water;
    const double speed = particles_.u[i].norm();
    if (!(speed <= fastest)) which = i, fastest = speed;
    if (neighbors_.count(i) > loose) fastest_bound = std::max(fastest_bound, speed);
    if (std::isnan(speed)) break;
  }
  check_bounds(water, which, fastest, end);
  const double driven = std::max(driven_speed_, wall_speed), larger = courant(driven) / towards_faces;
  if (larger > 1) fastest_bound = std::max(fastest_bound, larger * approach_to_faces(fastest_bound / larger));
  const double flight = free_flight * water_.spacing / std::max(fastest, 1e-12);
  return {.pressure = {},
          .max_speed = fastest,
          .max_window = std::min(flight, longest_step(fastest_bound, driven))};
}

/// Limits of eq. (17) [s] except the second one, for water, walls and bodies with speeds up to `speed`, and
/// walls and bodies that are driven into the water at speeds up to `driven` [m/s].
template <int dim>
double Mps<dim>::longest_step(double speed, double driven) const {
  return cosurge::longest_step({.spacing = water_.spacing,
                                .gravity = water_.gravity.norm(),
                                .viscosity = water_.kinematic_viscosity,
                                .propagation_speed = open_surface() ? propagation_speed_ : 0},
                               courant(driven), speed);
}

template <int dim>
double Mps<dim>::first_window(double longest) const {
  double window = std::min(longest, longest_step(max_body_speed_, 0));
  // Halved until it fits the speeds of the walls within it: their mean over a short window may be larger.
  const auto allowed = [&](double speed) { return longest_step(speed, speed); };
  while (window > allowed(walls_.speed_between(0, window))) window /= 2;
  return window;
}

template StepReport Mps<2>::survey(double, double);
template StepReport Mps<3>::survey(double, double);
template double Mps<2>::first_window(double) const;
template double Mps<3>::first_window(double) const;

}  // namespace cosurge::fluid
