#include "common/state_bytes.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

/// Visits all that a state has besides the added mass, in its order.
template <int dim>
template <typename Self, typename Visit>
void Mps<dim>::each_field(Self& self, Visit&& visit) {
  visit(self.particles_.x);
  visit(self.particles_.u);
  visit(self.particles_.p);
  visit(self.particles_.n);
  visit(self.particles_.normal);
  visit(self.particles_.kind);
  visit(self.particles_.id);
  visit(self.particles_.free_surface);
  visit(self.faces_.area);
  visit(self.covered_faces_.film());
  visit(self.max_body_speed_);
}

template <int dim>
std::string Mps<dim>::save() const {
  StateWriter state;
  each_field(*this, [&](const auto& field) { state.put(field); });
  added_mass_.save(state);
  return state.take();
}

template <int dim>
void Mps<dim>::restore(const std::string& bytes) {
  StateReader state(bytes);
  each_field(*this, [&](auto& field) { state.get(field); });
  added_mass_.restore(state);
  state.finish();
  locate_bodies();
  covers_.clear();  // the next step begins with finding them
}

template std::string Mps<2>::save() const;
template std::string Mps<3>::save() const;
template void Mps<2>::restore(const std::string& state);
template void Mps<3>::restore(const std::string& state);

}  // namespace cosurge::fluid
