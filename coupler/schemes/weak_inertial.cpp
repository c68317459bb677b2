#include "coupler/schemes/weak_inertial.hpp"

namespace cosurge {

Reports WeakInertial::advance(const Window& window, Surface& surface, InterfaceAccount& account) {
  account.open(surface);
  const Field start = surface.displacement;
  Window attempt = window;
  attempt.attempt = 1;
  participants_.solid->advance(attempt, surface);

  surface.displacement = start;
  const Report fluid = participants_.fluid->advance(window, surface);
  Field seen = surface.velocity;
  for (const Mode& mode : surface.modes)
    seen += mode.mobility * (mode.shape.cwiseProduct(surface.force).sum() - mode.load) * mode.shape;

  attempt.attempt = 2;
  const Report solid = participants_.solid->advance(attempt, surface);
  account.close(surface, seen, window);
  ratio_.passed(surface.velocity, window);
  effort_ = one_exchange(seen, surface.velocity);
  return {fluid, solid};
}

}  // namespace cosurge
