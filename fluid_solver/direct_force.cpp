#include "fluid_solver/direct_force.hpp"

namespace cosurge::fluid {

template <int dim>
void DirectForce<dim>::clear(int particles) {
  force_.assign(static_cast<std::size_t>(particles), Vec<dim>::Zero());
  struck_.assign(static_cast<std::size_t>(particles), 0);
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
                                    double factor) {
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int j = 0; j < particles.size(); ++j) {
    if (particles.kind[j] == Kind::fluid) continue;
    Vec<dim> sum = Vec<dim>::Zero();
    neighbors.each_weighted(particles, j, [&](int i, const Vec<dim>&, double, double w) {
      if (particles.kind[i] == Kind::fluid) sum += w * (particles.u[i] - particles.u[j]);
    });
    force_[static_cast<std::size_t>(j)] += factor * sum;
  }
}

template class DirectForce<2>;
template class DirectForce<3>;

}  // namespace cosurge::fluid
