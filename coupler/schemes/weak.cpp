#include "coupler/schemes/weak.hpp"

namespace cosurge {

Reports Weak::advance(const Window& window, Surface& surface, InterfaceAccount& account) {
  Reports reports;
  account.open(surface);
  const Field before = surface.velocity;
  surface.velocity = prediction_.next(before, window);
  const Field seen = surface.velocity;
  if (participants_.fluid != nullptr) reports.push_back(participants_.fluid->advance(window, surface));
  if (participants_.solid != nullptr) reports.push_back(participants_.solid->advance(window, surface));
  account.close(surface, seen, window);
  prediction_.passed(before, window);
  ratio_.passed(surface.velocity, window);
  effort_ = one_exchange(seen, surface.velocity);
  return reports;
}

void Weak::save(StateWriter& state) const {
  prediction_.save(state);
  ratio_.save(state);
}

void Weak::restore(StateReader& state) {
  prediction_.restore(state);
  ratio_.restore(state);
}

}  // namespace cosurge
