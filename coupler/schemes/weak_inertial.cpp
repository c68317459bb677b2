#include "coupler/schemes/weak_inertial.hpp"

#include "coupler/schemes/inertial.hpp"

namespace cosurge {

Reports WeakInertial::advance(const Window& window, Surface& surface, InterfaceAccount& account) {
  account.open(surface);
  const Field start = surface.displacement;
  predict_motion(participants_, window, surface);
  surface.displacement = start;
  const Report fluid = participants_.fluid->advance(window, surface);
  const Field seen = surface.velocity + velocity_of(surface.modes, surface.force);

  Window attempt = window;
  attempt.attempt = 2;
  const Report solid = participants_.solid->advance(attempt, surface);
  account.close(surface, seen, window);
  ratio_.passed(surface.velocity, window);
  effort_ = one_exchange(seen, surface.velocity);
  return {fluid, solid};
}

}  // namespace cosurge
