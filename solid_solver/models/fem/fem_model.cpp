#include "solid_solver/models/fem/fem_model.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "solid_solver/damping.hpp"

namespace cosurge::fem {
namespace {

constexpr double whole = 1e-6;  // of a sub-step: a window of 20.0000001 sub-steps is one of 20

}  // namespace

template <int dim>
FemModel<dim>::FemModel(const v1::Solid& solid, double spacing, const Vec<dim>& gravity)
    : bodies_(solid, spacing, gravity), substep_(solid.fem().substep()) {
  const std::vector<double> damping = damping_rates<dim>(solid);
  for (const FemBody<dim>& body : bodies_.bodies()) {
    motions_.emplace_back(body, solid.fem().rho_infinity(), damping[motions_.size()]);
    ramp_increment_.push_back(Vector::Zero(body.unknowns()));
  }
}

template <int dim>
int FemModel<dim>::advance(const Window& window, const NodalLoad& load) {
  const int substeps =
      substep_ > 0 ? std::max(1, static_cast<int>(std::ceil(window.size / substep_ - whole))) : 1;
  const double dt = window.size / substeps;
  iterations_ = 0;
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    GeneralisedAlpha<dim>& motion = motions_[b];
    const Vector first = bodies_.of_body(b, load.first), change = bodies_.of_body(b, load.last) - first;
    ramp_increment_[b].setZero();
    motion.start(first);
    for (int k = 0; k < substeps; ++k) {
      const double s = (k + motion.load_instant()) / substeps;
      const Vector before = motion.displacement();
      const NewtonReport report = motion.step(first + s * change, dt);
      check_step(report, window, b, dt);
      iterations_ += report.iterations;
      ramp_increment_[b] += s * (motion.displacement() - before);
    }
  }
  bodies_.check_motion(window, velocities());
  return substeps;
}

template <int dim>
void FemModel<dim>::check_step(const NewtonReport& report, const Window& window, std::size_t body,
                               double dt) const {
  if (report.converged) return;
  throw NumericalError(fmt::format(
      "solid: no balance of forces in body {} in the window from t = {:.6g} s: after {} Newton iterations "
      "with "
      "a step of {:.3g} s the residual is {:.2g} of the largest force, the smallest volume ratio {:.2g}. The "
      "step is too long for this motion (lower solid.fem.substep), or the load runs away (coupling.load = "
      "\"ramped\", a shorter time.window, or a heavier body)",
      body, window.start, report.iterations, dt, report.residual, report.least_volume));
}

template <int dim>
typename FemModel<dim>::Vectors FemModel<dim>::displacements() const {
  Vectors all;
  for (const auto& motion : motions_) all.push_back(motion.displacement());
  return all;
}

template <int dim>
typename FemModel<dim>::Vectors FemModel<dim>::velocities() const {
  Vectors all;
  for (const auto& motion : motions_) all.push_back(motion.velocity());
  return all;
}

template <int dim>
Energies FemModel<dim>::energies() const {
  Energies sum;
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    const FemBody<dim>& body = bodies_.bodies()[b];
    const Vector &u = motions_[b].displacement(), &v = motions_[b].velocity();
    sum.kinetic += 0.5 * v.dot(body.momentum(v));
    sum.elastic += body.elastic_energy(u);
    sum.gravity -= body.weight().dot(u);
  }
  return sum;
}

template <int dim>
std::string FemModel<dim>::save() const {
  StateWriter state;
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    motions_[b].save(state);
    state.put(ramp_increment_[b]);
  }
  return state.take();
}

template <int dim>
void FemModel<dim>::restore(const std::string& text) {
  StateReader state(text);
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    motions_[b].restore(state);
    state.get(ramp_increment_[b]);
  }
  state.finish();
}

template class FemModel<2>;
template class FemModel<3>;

}  // namespace cosurge::fem
