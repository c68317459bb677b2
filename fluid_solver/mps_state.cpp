#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

/// Visits everything that a saved state contains, except the added mass, in the order of the state.
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
  check_state();
  locate_bodies();
  covers_.clear();  // found again at the beginning of the next step
}

/// Checks the lengths and ids of a restored state, on which all other code relies. @throws Error
template <int dim>
void Mps<dim>::check_state() const {
  const Particles<dim>& all = particles_;
  const std::size_t count = all.x.size();
  for (const std::size_t length : {all.u.size(), all.p.size(), all.n.size(), all.normal.size(),
                                   all.kind.size(), all.id.size(), all.free_surface.size()})
    require(length == count, "saved state: {} entries for {} particles; it belongs to another case or build",
            length, count);
  require(faces_.area.empty() || static_cast<std::int64_t>(faces_.area.size()) == bodies_.points(),
          "saved state: areas of {} points, the bodies have {}; it belongs to another case or build",
          faces_.area.size(), bodies_.points());
  std::vector<bool> there(static_cast<std::size_t>(initial_size()));
  for (std::size_t i = 0; i < count; ++i) {
    const auto id = static_cast<std::size_t>(all.id[i]);  // a negative number becomes too large
    require(id < there.size() && !there[id] && all.kind[i] <= Kind::body_inner && all.x[i].allFinite(),
            "saved state: particle {} has id {} of {} (twice: {}), kind {} and its place is {}; the state is "
            "damaged, or belongs to another case or build",
            i, all.id[i], there.size(), id < there.size() && there[id], static_cast<int>(all.kind[i]),
            all.x[i].allFinite() ? "finite" : "no number");
    there[id] = true;
  }
}

template std::string Mps<2>::save() const;
template std::string Mps<3>::save() const;
template void Mps<2>::restore(const std::string& state);
template void Mps<3>::restore(const std::string& state);

}  // namespace cosurge::fluid
