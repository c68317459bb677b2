#include "fluid_solver/density.hpp"

#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {

template <int dim>
void density_and_free_surface(Particles<dim>& particles, const Neighbors<dim>& neighbors, double n0,
                              const FreeSurfaceCriterion& criterion) {
  constexpr int few = dim == 2 ? 3 : 5;  // neighbours that cannot hold a pressure between them
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int i = 0; i < particles.size(); ++i) {
    if (!has_pressure(particles.kind[i])) continue;
    double n = 0;
    Vec<dim> moment = Vec<dim>::Zero();
    neighbors.each(particles, i, [&](int, const Vec<dim>& x_ij, double r) {
      const double w = weight(r, neighbors.re());
      n += w;
      moment += w * x_ij;
    });
    particles.n[i] = n;
    const bool thin = n < criterion.beta * n0 && moment.norm() > criterion.delta * n;
    particles.free_surface[i] = static_cast<std::uint8_t>(thin || neighbors.count(i) <= few);
  }
}

template void density_and_free_surface<2>(Particles<2>&, const Neighbors<2>&, double,
                                          const FreeSurfaceCriterion&);
template void density_and_free_surface<3>(Particles<3>&, const Neighbors<3>&, double,
                                          const FreeSurfaceCriterion&);

}  // namespace cosurge::fluid
