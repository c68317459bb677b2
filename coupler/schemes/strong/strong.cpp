#include "coupler/schemes/strong/strong.hpp"

#include <algorithm>

namespace cosurge {
namespace {

/// The larger of a value and what it has changed by in the window: either may pass through zero.
double scale_of(const Field& value, const Field& before) {
  return std::max(value.norm(), (value - before).norm());
}

double relative(double part, double whole) { return part > 0 ? part / whole : 0; }

}  // namespace

Strong::Strong(const v1::Coupling& coupling, Participants participants)
    : tolerance_(coupling.iteration().tolerance()),
      iterations_(coupling.iteration().limit()),
      participants_(participants),
      prediction_(coupling.prediction()),
      relaxation_(make_relaxation(coupling.iteration())) {}

Reports Strong::advance(const Window& window, Surface& surface, InterfaceAccount& account) {
  account.open(surface);
  const Surface start = surface;
  Field velocity = prediction_.next(start.velocity, window);
  Surface before;  // of the last iteration
  Field velocity_before;
  Reports reports;
  effort_ = {.iterations = 0, .residual = 0, .note = {}, .converged = false};
  while (!effort_.converged && effort_.iterations < iterations_) {
    Window attempt = window;
    attempt.attempt = static_cast<std::uint32_t>(++effort_.iterations);
    surface = start;
    surface.velocity = velocity;
    reports = {participants_.fluid->advance(attempt, surface),
               participants_.solid->advance(attempt, surface)};
    has_modes_ = has_modes_ || !surface.modes.empty();
    surface.modes.clear();
    const Field residual = surface.velocity - velocity;
    effort_.residual = relative(residual.norm(), scale_of(surface.velocity, start.velocity));
    if (effort_.iterations > 1) {
      const Field change = velocity - velocity_before;
      const double steepness = (surface.force - before.force).norm() / change.norm();
      stiffness_ = effort_.iterations == 2 ? steepness : std::max(stiffness_, steepness);
      if (effort_.iterations == 2) ratio_.iterated(change, surface.velocity - before.velocity);
    }
    effort_.converged = effort_.residual == 0 ||
                        (stiffness_ >= 0 && effort_.residual <= tolerance_ &&
                         stiffness_ * residual.norm() <= tolerance_ * scale_of(surface.force, start.force));
    before = surface;
    velocity_before = velocity;
    if (!effort_.converged) velocity.reshaped() = relaxation_->next(velocity.reshaped(), residual.reshaped());
  }
  relaxation_->end_window();
  account.close(surface, velocity_before, window);
  prediction_.passed(start.velocity, window);
  return reports;
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
