#include "fluid_solver/direct_force.hpp"

namespace cosurge::fluid {

template <int dim>
void DirectForce<dim>::clear(int particles) {
  force_.assign(static_cast<std::size_t>(particles), Vec<dim>::Zero());
  struck_.assign(static_cast<std::size_t>(particles), 0);
  rubs_.assign(static_cast<std::size_t>(particles), 0);
}

template <int dim>
void DirectForce<dim>::add_collisions(const Particles<dim>& particles, const Neighbors<dim>& neighbors,
                                      const CollisionLaw& law, double mass, double dt) {
  // Few particles, and in order: the sums have the same bits with any number of threads.
  for (int i = 0; i < particles.size(); ++i)
    if (struck_[static_cast<std::size_t>(i)] != 0)
      collision(particles, neighbors, i, law, [&](int j, const Vec<dim>& change) {
        force_[static_cast<std::size_t>(j)] -= mass / dt * change;
      });
}

template <int dim>
void DirectForce<dim>::add_friction(const Particles<dim>& particles, const Neighbors<dim>& neighbors,
                                    double spacing, const Vec<dim>& kick, double factor) {
  // In order: the sums have the same bits with any number of threads.
  for (int i = 0; i < particles.size(); ++i) {
    if (rubs_[static_cast<std::size_t>(i)] == 0) continue;
    const FaceBefore<dim> face = face_before(particles, neighbors, i, spacing);
    neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>&, double, double w) {
      if (particles.kind[j] == Kind::fluid) return;
      const int felt_by = has_pressure(particles.kind[j]) ? j : face.place;
      force_[static_cast<std::size_t>(felt_by)] -=
          factor * w * beyond_face(particles, i, j, face, kick).of_motion;
    });
  }
}

template class DirectForce<2>;
template class DirectForce<3>;

}  // namespace cosurge::fluid
