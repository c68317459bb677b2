// The source of the pressure equation: density and divergence of the predicted state.
#include <algorithm>
#include <cmath>

#include "common/water_step.hpp"
#include "fluid_solver/closing_speed.hpp"
#include "fluid_solver/mps.hpp"
#include "fluid_solver/operators.hpp"
#include "fluid_solver/pressure/source.hpp"

namespace cosurge::fluid {

/// Change of the source per divergence of the velocity, for the case's choice.
template <int dim>
void Mps<dim>::set_source_per_divergence(double dt) {
  const double rho = water_.density;
  const auto size = static_cast<std::size_t>(particles_.size());
  switch (water_.method.source) {
    case Source::deviation:
      return source_per_divergence_.clear();
    case Source::mixed:
      return source_per_divergence_.assign(size, (1 - water_.method.gamma) * rho / dt);
    case Source::time_scale:
      source_per_divergence_.assign(size, rho * rates(dt).divergence);
  }
  constexpr double answers = 2;  // term 2 a_i of eq. (6c): corrections per spacing
  const double most = 1 / dt;
  const Vec<dim> kick = dt * water_.gravity;
  const auto& unknowns = poisson_.unknowns();
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (std::size_t m = 0; m < unknowns.size(); ++m) {
    const std::int32_t i = unknowns[m];
    const double k =
        answers * approach_speed(particles_, neighbors_, i, kick, water_.spacing) / water_.spacing;
    source_per_divergence_[i] = std::max(source_per_divergence_[i], rho * std::min(k, most));
  }
}

template <int dim>
double Mps<dim>::least_per_change(double dt) const {
  return open_surface() ? water_.density * rates(dt).bodies : 0;
}

/// Change of the velocity of the bodies' points since the last window, dimension x points [m/s].
template <int dim>
Field Mps<dim>::body_change() const {
  Field change = -last_body_velocity_;
  for (int k = 0; k < bodies_.points(); ++k) change.col(k) += particles_.u[body_place_[k]];
  return change;
}

/// Adds eq. (6d) to the source of eq. (6c).
template <int dim>
void Mps<dim>::add_source_of_bodies(double dt) {
  const std::vector<double> divergence = body_divergence(bodies_in_water(), body_change());
  const double least = least_per_change(dt);
  const auto& unknowns = poisson_.unknowns();
  for (std::size_t m = 0; m < unknowns.size(); ++m) {
    const std::int32_t i = unknowns[m];
    source_[i] += (std::max(source_per_divergence_[i], least) - source_per_divergence_[i]) * divergence[m];
  }
}

/// Right-hand side S of the pressure equation for each particle, by the case's choice.
template <int dim>
void Mps<dim>::set_source(double dt) {
  const double k_n = rates(dt).density;
  const auto source = [&](const SourceInput& in) {
    switch (water_.method.source) {
      case Source::deviation:
        return deviation_source(in, water_.method.gamma);
      case Source::mixed:
        return mixed_source(in, water_.method.gamma);
      case Source::time_scale:
        return time_scale_source(in, k_n);
    }
    return 0.0;
  };
  const bool paper = water_.method.source == Source::deviation;
  const Vec<dim> kick = dt * water_.gravity;
  const auto& unknowns = poisson_.unknowns();
  std::vector<double> divergence;
  if (!paper) divergence = poisson_.divergence(particles_, neighbors_.grid(), kick);
  source_.assign(static_cast<std::size_t>(particles_.size()), 0.0);
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (std::size_t m = 0; m < unknowns.size(); ++m) {
    const std::int32_t i = unknowns[m];
    SourceInput in{.density = water_.density, .dt = dt, .deviation = near_deviation(i)};
    if (!paper) {
      in.deviation = unbiased_deviation(i, poisson_.deviation()[m]);
      in.divergence = std::isnan(divergence[m])
                          ? near_divergence(particles_, particles_.u, neighbors_, i, reference_.n0, kick)
                          : divergence[m];
      in.per_divergence = source_per_divergence_[i];
    }
    source_[i] = source(in);
  }
  if (bodies_.points() > 0 && open_surface() && rates(dt).bodies > rates(dt).divergence)
    add_source_of_bodies(dt);
  for (const int i : film_pressure_.particles_in_gap(body_place_, particles_, neighbors_, water_.spacing))
    source_[static_cast<std::size_t>(i)] = 0;
  poisson_.set_source(source_);
}

/// (n - n0) / n0 with the small radius.
template <int dim>
double Mps<dim>::near_deviation(int i) const {
  return particles_.n[i] / reference_.n0 - 1;
}

/// Deviation of the density without the bias by disorder (docs/method.md, "Which density"). Disorder raises
/// the number density of the small radius by 4 to 6 %, so that water kept at n0 would expand by as much. The
/// smooth density deviates by less than 0.2 %, and with eq. (2c) by a third of that. Beside the free surface
/// the smooth density of the large radius is not known and that of the small radius is used; beside an open
/// surface only its positive deviations count, because missing neighbours do not mean a low density. Walls
/// and bodies have no deviation: they cannot move to correct it.
template <int dim>
double Mps<dim>::unbiased_deviation(int i, double smooth) const {
  if (particles_.kind[i] != Kind::fluid) return 0;
  if (!open_surface()) return std::isnan(smooth) ? near_deviation(i) : smooth;
  const double near = smooth_density_[static_cast<std::size_t>(i)] / reference_.smooth0 - 1;
  if (std::isnan(smooth)) return std::max(0.0, near);
  // Deviation caused by disorder: that of the large radius divided by that of the small one. A deviation
  // above `most` is not disorder but a gap or a jam.
  constexpr double bias = dim == 2 ? 0.17 : 0.07;
  constexpr double most = 0.1;
  const double disorder = std::max(0.0, 1 - std::abs(near) / most) * bias;
  return (smooth - disorder * near) / (1 - disorder);
}

/// Rates of the scene for the source `time_scale`, eq. (6c) and (6d): c / l0 for water that flows under
/// gravity, 15 V / l0 for an obstacle or body driven into the water at V, and 20 omega for a structure that
/// oscillates at omega.
template <int dim>
Rates Mps<dim>::rates(double dt) const {
  constexpr double answers_to_bodies = 20;  // corrections per radian of the structure's oscillation, eq. (6d)
  const double c = propagation_speed_ / water_.spacing;
  const double driven = driven_speed_ / water_.spacing;
  const double k = std::min(std::max(c, answers_to_walls * driven), 1 / dt);
  return {.divergence = k,
          .density = std::min(k, std::max(c, driven)),
          .bodies = std::max(k, std::min(answers_to_bodies * frequency_, 1 / dt))};
}

/// Finds V of eq. (6c): the largest speed at which walls and bodies are driven into the water.
template <int dim>
void Mps<dim>::find_driven_speed(double end, double dt) {
  const DrivenBodies<dim> driven{.bodies = bodies_, .normal = faces_.normal, .place = body_place_};
  driven_speed_ = std::max(walls_.approach(), closing_speed(driven, particles_, neighbors_, walls_, end, dt));
}

/// tau of eq. (11) [s]. In equilibrium alpha rho P / tau^2 = rho k_n^2 (n - n0) / n0, so that tau = 1 / k_n
/// gives the compressibility alpha.
template <int dim>
double Mps<dim>::response_time(double dt) const {
  return open_surface() ? 1 / rates(dt).density : dt;
}

template void Mps<2>::find_driven_speed(double, double);
template void Mps<3>::find_driven_speed(double, double);
template Field Mps<2>::body_change() const;
template Field Mps<3>::body_change() const;
template void Mps<2>::add_source_of_bodies(double);
template void Mps<3>::add_source_of_bodies(double);
template double Mps<2>::least_per_change(double) const;
template double Mps<3>::least_per_change(double) const;
template void Mps<2>::set_source(double);
template void Mps<3>::set_source(double);
template void Mps<2>::set_source_per_divergence(double);
template void Mps<3>::set_source_per_divergence(double);
template double Mps<2>::response_time(double) const;
template double Mps<3>::response_time(double) const;

}  // namespace cosurge::fluid
