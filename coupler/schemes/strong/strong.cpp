#include "coupler/schemes/strong/strong.hpp"

#include <algorithm>

#include "coupler/schemes/inertial.hpp"

namespace cosurge {
namespace {

/// The larger of a value and its change in the window: either may pass through zero.
double scale_of(const Field& value, const Field& before) {
  return std::max(value.norm(), (value - before).norm());
}

double relative(double part, double whole) { return part > 0 ? part / whole : 0; }

}  // namespace

Strong::Strong(const v1::Coupling& coupling, Participants participants)
    : tolerance_(coupling.iteration().tolerance()),
      iterations_(coupling.iteration().limit()),
      participants_(participants),
      inertial_(coupling.scheme() == v1::Coupling::strong_inertial),
      prediction_(coupling.prediction()),
      relaxation_(make_relaxation(coupling.iteration())) {}

Reports Strong::advance(const Window& window, Surface& surface, InterfaceAccount& account) {
  account.open(surface);
  const Surface start = surface;
  if (inertial_) {
    predict_motion(participants_, window, surface);
    modes_ = std::move(surface.modes);
  }
  Field velocity = inertial_ ? surface.velocity : prediction_.next(start.velocity, window);
  Pass last, nearest;
  Reports reports;
  effort_ = {.iterations = 0, .residual = 0, .note = {}, .converged = false};
  while (!effort_.converged && effort_.iterations < iterations_) {
    reports = pass(window, start, velocity, surface);
    const Pass now{.asked = velocity,
                   .seen = velocity + velocity_of(modes_, surface.force),
                   .answer = surface.velocity,
                   .force = surface.force};
    if (effort_.iterations > 1) learn(now, last);
    effort_.residual = relative(now.residual(), scale_of(now.answer, start.velocity));
    effort_.converged = effort_.residual == 0 ||
                        (stiffness_ >= 0 && effort_.residual <= tolerance_ &&
                         stiffness_ * now.residual() <= tolerance_ * scale_of(now.force, start.force));
    if (nearest.seen.size() == 0 || now.residual() < nearest.residual()) nearest = now;
    last = now;
    if (!effort_.converged)
      velocity.reshaped() = relaxation_->next(velocity.reshaped(), (now.answer - now.seen).reshaped());
  }
  if (!effort_.converged) {
    reports = pass(window, start, nearest.asked, surface);
    last = nearest;
  }
  relaxation_->end_window();
  account.close(surface, last.seen, window);
  prediction_.passed(start.velocity, window);
  if (inertial_) ratio_.passed(surface.velocity, window);
  return reports;
}

Reports Strong::pass(const Window& window, const Surface& start, const Field& velocity, Surface& surface) {
  Window attempt = window;
  attempt.attempt = static_cast<std::uint32_t>(++effort_.iterations);
  surface = start;
  surface.velocity = velocity;
  surface.modes = modes_;
  Reports reports = {participants_.fluid->advance(attempt, surface)};
  if (inertial_) ++attempt.attempt;  // the first was the answer to the last load
  reports.push_back(participants_.solid->advance(attempt, surface));
  has_modes_ = has_modes_ || !surface.modes.empty();
  surface.modes.clear();
  return reports;
}

void Strong::learn(const Pass& now, const Pass& last) {
  const Field change = now.seen - last.seen;
  const double steepness = (now.force - last.force).norm() / change.norm();
  const bool first = effort_.iterations == 2;
  stiffness_ = first ? steepness : std::max(stiffness_, steepness);
  if (first && !inertial_) ratio_.iterated(change, now.answer - last.answer);
}

void Strong::save(StateWriter& state) const {
  prediction_.save(state);
  relaxation_->save(state);
  ratio_.save(state);
  state.put(stiffness_);
  state.put(has_modes_);
}

void Strong::restore(StateReader& state) {
  prediction_.restore(state);
  relaxation_->restore(state);
  ratio_.restore(state);
  state.get(stiffness_);
  state.get(has_modes_);
}

}  // namespace cosurge
