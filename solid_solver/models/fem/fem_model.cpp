#include "solid_solver/models/fem/fem_model.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "solid_solver/damping.hpp"

namespace cosurge::fem {
namespace {

constexpr double whole = 1e-6;  // [sub-steps] tolerance: a window of 20.0000001 sub-steps has 20

// Stretch at the largest compressive force that St. Venant-Kirchhoff's material bears along one axis, for
// Poisson's ratio 0: 1 / sqrt(3).
constexpr double gives_way = 0.577;

}  // namespace

template <int dim>
FemModel<dim>::FemModel(const Structure<dim>& structure, const FemParameters& parameters)
    : bodies_(structure), substep_(parameters.substep) {
  const std::vector<double> damping = damping_rates(structure);
  for (const FemBody<dim>& body : bodies_.bodies()) {
    motions_.emplace_back(body, parameters.rho_infinity, damping[motions_.size()]);
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
  const Mesh<dim>& mesh = bodies_.bodies()[body].mesh();
  const Vec<dim> near = mesh.corners(report.flattest).rowwise().mean();
  const std::string where =
      fmt::format("in body {}, near ({:.4g}) when undeformed, in the window from t = {:.6g} s", body,
                  fmt::join(near.begin(), near.end(), ", "), window.start);
  if (!bodies_.material().neo_hookean && report.least_volume < gives_way)
    throw NumericalError(
        fmt::format("solid: the material collapses {}: an element is left with {:.2g} of its volume{}. "
                    "st_venant_kirchhoff is unstable when compressed below {:.2f} of its length, with any "
                    "step; use solid.material = \"neo_hookean\", which stiffens",
                    where, report.least_volume, report.least_volume <= 0 ? ", inverted" : "", gives_way));
  const std::string remedy = fmt::format(
      "The step of {:.3g} s is too long for this motion (solid.fem.substep = {:.2g}), or the load is "
      "unstable (coupling.load = \"ramped\", a shorter time.window, or a heavier body)",
      dt, dt / 4);
  if (report.least_volume <= 0)
    throw NumericalError(fmt::format("solid: an element {} is inverted: {:.2g} of its volume. {}", where,
                                     report.least_volume, remedy));
  throw NumericalError(fmt::format(
      "solid: no convergence {}: after {} Newton iterations the residual is {:.2g} of the largest force, "
      "limit {:.0e}; the smallest volume ratio is {:.2g}. {}",
      where, report.iterations, report.residual, NewtonReport::tolerance, report.least_volume, remedy));
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
void FemModel<dim>::place(const Vectors& displacements, const Vectors& velocities) {
  for (std::size_t b = 0; b < motions_.size(); ++b) motions_[b].place(displacements[b], velocities[b]);
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
