#include "coupler/schemes/weak.hpp"

namespace cosurge {

Reports Weak::advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) {
  Reports reports;
  account.open(interface);
  const Field before = interface.motion.velocity;
  interface.motion.velocity = prediction_.next(before, window);
  const Field seen = interface.motion.velocity;
  if (participants_.fluid != nullptr)
    reports.push_back(participants_.fluid->advance(window, interface.motion, interface.load));
  if (participants_.solid != nullptr)
    reports.push_back(participants_.solid->advance(window, interface.load, interface.motion));
  account.close(interface, seen, window);
  prediction_.passed(before, window);
  ratio_.passed(interface.motion.velocity, window);
  effort_ = one_exchange(seen, interface.motion.velocity);
  return reports;
}

void Weak::save(StateWriter& state) const {
  prediction_.save(state);
  ratio_.save(state);
}

void Weak::restore(InterfaceReader& state) {
  prediction_.restore(state);
  ratio_.restore(state);
}

}  // namespace cosurge
