// Water that falls towards a plate, in a tank of 0.3 m; and functions that change its state.
#pragma once

#include "common/state_bytes.hpp"
#include "fluid_solver/mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid::test {

constexpr double l0 = 0.01;
constexpr double g = 9.81;
inline const Vec<2> down(0, -g);

inline v1::Fluid small_dam_break() {
  return tank_of_water(l0, box_of({0, 0}, {0.3, 0.3}), {box_of({0, 0}, {0.1, 0.2})});
}

inline const v1::Solid plate = solid_of(box_of({0.15, 0}, {0.18, 0.08}), {box_of({0.15, -0.05}, {0.18, 0})});

/// Calls change(particle's velocity, position) for each fluid particle of a state, which is saved and
/// restored.
template <int dim, typename Change>
void change_velocities(Mps<dim>& mps, Change&& change) {
  Particles<dim> particles = mps.particles();
  for (int i = 0; i < particles.size(); ++i)
    if (particles.kind[i] == Kind::fluid) change(particles.u[i], particles.x[i]);
  // The rest of the state, as it is: everything after the velocities.
  StateWriter head;
  head.put(mps.particles().x);
  head.put(mps.particles().u);
  const std::string old = mps.save();
  StateWriter fresh;
  fresh.put(particles.x);
  fresh.put(particles.u);
  mps.restore(fresh.take() + old.substr(head.take().size()));
}

}  // namespace cosurge::fluid::test
