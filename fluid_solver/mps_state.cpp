#include "common/state_bytes.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

template <int dim>
std::string Mps<dim>::save() const {
  StateWriter state;
  state.put(particles_.x);
  state.put(particles_.u);
  state.put(particles_.p);
  state.put(particles_.n);
  state.put(particles_.kind);
  state.put(particles_.id);
  state.put(particles_.free_surface);
  state.put(body_areas_);
  state.put(max_body_speed_);
  added_mass_.save(state);
  return state.take();
}

template <int dim>
void Mps<dim>::restore(const std::string& bytes) {
  StateReader state(bytes);
  state.get(particles_.x);
  state.get(particles_.u);
  state.get(particles_.p);
  state.get(particles_.n);
  state.get(particles_.kind);
  state.get(particles_.id);
  state.get(particles_.free_surface);
  state.get(body_areas_);
  state.get(max_body_speed_);
  added_mass_.restore(state);
  state.finish();
  locate_bodies();
}

template std::string Mps<2>::save() const;
template std::string Mps<3>::save() const;
template void Mps<2>::restore(const std::string& state);
template void Mps<3>::restore(const std::string& state);

}  // namespace cosurge::fluid
