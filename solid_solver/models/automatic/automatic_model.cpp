#include "solid_solver/models/automatic/automatic_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.hpp"
#include "common/state_bytes.hpp"

namespace cosurge::automatic {
namespace {

constexpr double limit = 0.02;         // limit of nonlinearity and of truncation
constexpr double small = 0.5 * limit;  // both below it: modes are used again
constexpr double lost = 1e-3;     // largest share of displacement and energy that a return to modes may lose
constexpr int most_windows = 20;  // largest number of windows between two measurements
// A measurement is repeated when the displacement has grown by this factor, or so far that the limit may be
// near: both values are at most proportional to it.
constexpr double least_growth = 1.1, most_growth = 10, share = 0.5;

double growth(double value) { return std::clamp(share * limit / value, least_growth, most_growth); }

template <int dim>
double largest_of(const fem::FemBody<dim>& body, const fem::Vector& u) {
  return body.to_nodes(u).colwise().norm().maxCoeff();
}

double largest_force(const NodalLoad& load) {
  return std::max(load.first.lpNorm<Eigen::Infinity>(), load.last.lpNorm<Eigen::Infinity>());
}

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

/// Displacement difference of the nonlinear from the linear solution under the same forces, over the latter
/// (S48). While elements compute, the estimate by one Newton step is used: it can only delay the return to
/// modes.
template <int dim>
double nonlinearity(const fem::FemBody<dim>& body, const LinearTheory<dim>& theory, const fem::Vector& u,
                    bool by_elements) {
  const double largest = largest_of(body, u);
  const double estimate = ratio(largest_of(body, theory.correction(u)), largest);
  if (estimate <= limit || by_elements) return estimate;
  const std::optional<fem::Vector> nonlinear = theory.nonlinear(u);
  return nonlinear ? ratio(largest_of(body, fem::Vector(*nonlinear - u)), largest) : estimate;
}

}  // namespace

template <int dim>
AutomaticModel<dim>::AutomaticModel(const Structure<dim>& structure, const AutomaticParameters& parameters)
    : structure_(structure),
      parameters_(parameters),
      modal_(structure, parameters.modal),
      only_elements_(modal_.has_free_motion()) {
  const auto& bodies = modal_.bodies().bodies();
  watch_.deflection = watch_.displacement = fem::Vector::Zero(static_cast<Eigen::Index>(bodies.size()));
  if (only_elements_) {
    fem_.emplace(structure_, parameters_.fem);
    return;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    theories_.emplace_back(bodies[b]);
    period_ = std::max(period_, 2 * std::numbers::pi / std::sqrt(modal_.modes(b).omega_squared.minCoeff()));
  }
}

template <int dim>
int AutomaticModel<dim>::advance(const Window& window, const NodalLoad& load) {
  ++watch_.windows;
  if (only_elements_ && window.index == 0 && notes_.empty())
    notes_.push_back("model auto: fem for the whole run, since a body can move as a whole");
  if (!only_elements_ && fem_) take_modes_if_valid(window, load);
  if (fem_) {
    watch_.quiet += window.size;
    return fem_->advance(window, load);
  }
  const std::string start = modal_.save();
  modal_.advance(window, load);
  if (watch_.truncation > limit) watch_.lacking += window.size;
  if (!is_due(load) && watch_.lacking < period_) return 1;
  measure(modal_.displacements(), load);
  if (watch_.truncation <= limit) watch_.lacking = 0;
  const std::string reason = exceeded();
  if (reason.empty()) return 1;
  modal_.restore(start);
  take_elements(window, reason);
  return fem_->advance(window, load);
}

template <int dim>
bool AutomaticModel<dim>::is_due(const NodalLoad& load) const {
  return watch_.windows >= most_windows || modal_.energies().elastic > watch_.energy ||
         largest_force(load) > watch_.force;
}

template <int dim>
void AutomaticModel<dim>::measure(const Vectors& displacements, const NodalLoad& load) {
  const auto& bodies = modal_.bodies().bodies();
  watch_.nonlinearity = watch_.truncation = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const fem::FemBody<dim>& body = bodies[b];
    watch_.nonlinearity =
        std::max(watch_.nonlinearity, nonlinearity(body, theories_[b], displacements[b], fem_.has_value()));
    const fem::Vector force = modal_.bodies().of_body(b, load.last) + body.weight();
    const fem::Vector all = theories_[b].deflection(force);
    double& largest = watch_.deflection[static_cast<Eigen::Index>(b)];
    largest = std::max(largest, largest_of(body, all));
    const auto missing = largest_of(body, fem::Vector(all - modal_.deflection(b, force)));
    watch_.truncation = std::max(watch_.truncation, ratio(missing, largest));
  }
  const double displacement_growth = growth(watch_.nonlinearity);
  watch_.energy = displacement_growth * displacement_growth * modal_.energies().elastic;
  watch_.force = growth(watch_.truncation) * largest_force(load);
  watch_.windows = 0;
}

/// The reason why the modes are not valid; empty if they are.
template <int dim>
std::string AutomaticModel<dim>::exceeded() const {
  if (watch_.nonlinearity > limit)
    return fmt::format(
        "the deflection is no longer small: the nonlinear one differs by about {:.2g} %, limit {:g} %",
        100 * watch_.nonlinearity, 100 * limit);
  if (watch_.lacking >= period_)
    return fmt::format(
        "{} modes are not enough: for a period of {:.3g} s they have lacked more than {:g} % of the "
        "static deflection, {:.2g} % now",
        parameters_.modal.modes, period_, 100 * limit, 100 * watch_.truncation);
  return {};
}

template <int dim>
void AutomaticModel<dim>::take_elements(const Window& window, const std::string& reason) {
  fem_.emplace(structure_, parameters_.fem);
  // A body that has been bent by modes is stretched: the nonlinear displacement has nearly the same energy.
  Vectors displacements = modal_.displacements();
  for (std::size_t b = 0; b < displacements.size(); ++b)
    if (const auto nonlinear = theories_[b].nonlinear(displacements[b])) displacements[b] = *nonlinear;
  fem_->place(displacements, modal_.velocities());
  watch_.quiet = watch_.lacking = 0;
  notes_.push_back(
      fmt::format("model auto: fem instead of modal from t = {:.6g} s: {}", window.start, reason));
}

template <int dim>
void AutomaticModel<dim>::take_modes_if_valid(const Window& window, const NodalLoad& load) {
  if (watch_.windows <= most_windows) return;
  const Vectors u = fem_->displacements();
  modal_.place(u, fem_->velocities());
  measure(u, load);
  const bool valid = watch_.nonlinearity < small && watch_.truncation < small && loses_little(u);
  if (!valid) watch_.quiet = 0;
  if (watch_.quiet < period_) return;
  fem_.reset();
  notes_.push_back(
      fmt::format("model auto: modal instead of fem from t = {:.6g} s: the deflection has been small for "
                  "a period of {:.3g} s",
                  window.start, period_));
}

/// Whether the modes contain nearly the whole motion of the elements, with the displacements u.
template <int dim>
bool AutomaticModel<dim>::loses_little(const Vectors& u) {
  const Vectors kept = modal_.displacements();
  bool little = true;
  for (std::size_t b = 0; b < u.size(); ++b) {
    const fem::FemBody<dim>& body = modal_.bodies().bodies()[b];
    double& largest = watch_.displacement[static_cast<Eigen::Index>(b)];
    largest = std::max(largest, largest_of(body, u[b]));
    little = little && largest_of(body, fem::Vector(u[b] - kept[b])) <= lost * largest;
  }
  const Energies elements = fem_->energies(), modes = modal_.energies();
  const double energy = elements.kinetic + elements.elastic;
  watch_.energy_before = std::max(watch_.energy_before, energy);
  return little && std::abs(energy - modes.kinetic - modes.elastic) <= lost * watch_.energy_before;
}

template <int dim>
std::vector<NodalMode> AutomaticModel<dim>::modes(int count) const {
  if (only_elements_) return {};
  return modal_.modes(count);
}

template <int dim>
std::vector<double> AutomaticModel<dim>::values() const {
  return {fem_ ? 1.0 : 0.0, watch_.nonlinearity, watch_.truncation};
}

template <int dim>
std::string AutomaticModel<dim>::save() const {
  StateWriter state;
  state.put(fem_.has_value());
  state.put(active().save());
  Watch::each(watch_, [&](const auto& value) { state.put(value); });
  return state.take();
}

template <int dim>
void AutomaticModel<dim>::restore(const std::string& text) {
  StateReader state(text);
  bool elements = false;
  std::string motion;
  state.get(elements);
  state.get(motion);
  if (elements && !fem_) fem_.emplace(structure_, parameters_.fem);
  if (!elements) fem_.reset();
  if (elements)
    fem_->restore(motion);
  else
    modal_.restore(motion);
  Watch::each(watch_, [&](auto& value) { state.get(value); });
  state.finish();
}

template class AutomaticModel<2>;
template class AutomaticModel<3>;

}  // namespace cosurge::automatic
