#include "coupler/schemes/weak_inertial.hpp"

#include "coupler/schemes/inertial.hpp"

namespace cosurge {

Reports WeakInertial::advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) {
  account.open(interface);
  const Field start = interface.motion.displacement;
  predict_motion(participants_, window, interface);
  interface.motion.displacement = start;
  const Report fluid = participants_.fluid->advance(window, interface.motion, interface.load);
  const Field seen = interface.motion.velocity + velocity_of(interface.motion.modes, interface.load.force);

  Window attempt = window;
  attempt.attempt = Attempt::again;
  const Report solid = participants_.solid->advance(attempt, interface.load, interface.motion);
  account.close(interface, seen, window);
  ratio_.passed(interface.motion.velocity, window);
  effort_ = one_exchange(seen, interface.motion.velocity);
  return {fluid, solid};
}

}  // namespace cosurge
