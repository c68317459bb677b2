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

Reports Strong::advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) {
  account.open(interface);
  const InterfaceState start = interface;
  if (inertial_) {
    predict_motion(participants_, window, interface);
    modes_ = std::move(interface.motion.modes);
  }
  Field velocity = inertial_ ? interface.motion.velocity : prediction_.next(start.motion.velocity, window);
  Pass last, nearest;
  Reports reports;
  effort_ = {.iterations = 0, .residual = 0, .note = {}, .converged = false};
  while (!effort_.converged && effort_.iterations < iterations_) {
    reports = pass(window, start, velocity, interface);
    const Pass now{.asked = velocity,
                   .seen = velocity + velocity_of(modes_, interface.load.force),
                   .answer = interface.motion.velocity,
                   .force = interface.load.force};
    if (effort_.iterations > 1) learn(now, last);
    effort_.residual = relative(now.residual(), scale_of(now.answer, start.motion.velocity));
    effort_.converged = effort_.residual == 0 ||
                        (stiffness_ >= 0 && effort_.residual <= tolerance_ &&
                         stiffness_ * now.residual() <= tolerance_ * scale_of(now.force, start.load.force));
    if (nearest.seen.size() == 0 || now.residual() < nearest.residual()) nearest = now;
    last = now;
    if (!effort_.converged)
      velocity.reshaped() = relaxation_->next(velocity.reshaped(), (now.answer - now.seen).reshaped());
  }
  if (!effort_.converged) {
    reports = pass(window, start, nearest.asked, interface);
    last = nearest;
  }
  relaxation_->end_window();
  account.close(interface, last.seen, window);
  prediction_.passed(start.motion.velocity, window);
  if (inertial_) ratio_.passed(interface.motion.velocity, window);
  return reports;
}

Reports Strong::pass(const Window& window, const InterfaceState& start, const Field& velocity,
                     InterfaceState& interface) {
  Window attempt = window;
  attempt.attempt = ++effort_.iterations == 1 ? Attempt::first : Attempt::again;
  interface = start;
  interface.motion.velocity = velocity;
  interface.motion.modes = modes_;
  Reports reports = {participants_.fluid->advance(attempt, interface.motion, interface.load)};
  if (inertial_) attempt.attempt = Attempt::again;  // the first was the answer to the last load
  reports.push_back(participants_.solid->advance(attempt, interface.load, interface.motion));
  has_modes_ = has_modes_ || !interface.motion.modes.empty();
  interface.motion.modes.clear();
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

void Strong::restore(InterfaceReader& state) {
  prediction_.restore(state);
  relaxation_->restore(state);
  ratio_.restore(state);
  state.get(stiffness_);
  state.get(has_modes_);
}

}  // namespace cosurge
