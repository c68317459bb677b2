// What the pressure has to mend: density and divergence of the predicted state.
#include <cmath>

#include "fluid_solver/mps.hpp"
#include "fluid_solver/operators.hpp"
#include "fluid_solver/pressure/source.hpp"

namespace cosurge::fluid {

/// Right-hand side S of the pressure equation for each particle, by the case's choice.
template <int dim>
void Mps<dim>::set_source(double dt) {
  const double k = rate(dt);
  const auto source = [&](const SourceInput& in) {
    switch (parameters_.source()) {
      case v1::Fluid::deviation:
        return deviation_source(in, parameters_.gamma());
      case v1::Fluid::mixed:
        return mixed_source(in, parameters_.gamma());
      case v1::Fluid::time_scale:
        return time_scale_source(in, k);
    }
    return 0.0;
  };
  const bool paper = parameters_.source() == v1::Fluid::deviation;
  const Vec<dim> kick = dt * gravity_;
  const auto& unknowns = poisson_.unknowns();
  std::vector<double> wide;
  if (!paper) wide = poisson_.divergence(particles_, neighbors_.grid(), kick);
  source_.assign(static_cast<std::size_t>(particles_.size()), 0.0);
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (std::size_t m = 0; m < unknowns.size(); ++m) {
    const std::int32_t i = unknowns[m];
    SourceInput in{.density = parameters_.density(), .dt = dt, .deviation = 0, .divergence = 0};
    if (paper) {
      in.deviation = near_deviation(i);
    } else {
      in.deviation = unbiased_deviation(i, poisson_.deviation()[m]);
      in.divergence =
          std::isnan(wide[m]) ? divergence(particles_, neighbors_, i, reference_.n0, kick) : wide[m];
    }
    source_[i] = source(in);
  }
  poisson_.set_source(source_);
}

/// (n - n0) / n0 with the small radius.
template <int dim>
double Mps<dim>::near_deviation(int i) const {
  return particles_.n[i] / reference_.n0 - 1;
}

/// Disorder raises the number density of the small radius by 4 to 6 %, and water that is kept to it swells by
/// as much; the smooth density is off by less than 0.2 %. The small radius serves beside the free surface,
/// where the smooth one is not known. Only water counts: a wall cannot move to mend its own deviation, and
/// would keep a pressure for it.
template <int dim>
double Mps<dim>::unbiased_deviation(int i, double smooth) const {
  if (particles_.kind[i] != Kind::fluid) return 0;
  return std::isnan(smooth) ? near_deviation(i) : smooth;
}

/// Of the source `time_scale`: k of eq. (6c) [1/s].
template <int dim>
double Mps<dim>::rate(double dt) const {
  return std::min(propagation_speed_ / parameters_.spacing(), 1 / dt);
}

/// What the source changes by with the divergence of the velocity.
template <int dim>
double Mps<dim>::source_per_divergence(double dt) const {
  const double rho = parameters_.density();
  switch (parameters_.source()) {
    case v1::Fluid::deviation:
      return 0;
    case v1::Fluid::mixed:
      return (1 - parameters_.gamma()) * rho / dt;
    case v1::Fluid::time_scale:
      return rho * rate(dt);
  }
  return 0;
}

template void Mps<2>::set_source(double);
template void Mps<3>::set_source(double);
template double Mps<2>::source_per_divergence(double) const;
template double Mps<3>::source_per_divergence(double) const;

}  // namespace cosurge::fluid
