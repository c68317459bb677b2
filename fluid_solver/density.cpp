#include "fluid_solver/density.hpp"

#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

template <int dim>
constexpr int few = dim == 2 ? 3 : 5;  // neighbours that cannot hold a pressure between them

}  // namespace

template <int dim>
void density_and_free_surface(Particles<dim>& particles, const Neighbors<dim>& neighbors, double n0,
                              const FreeSurfaceCriterion& criterion) {
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int i = 0; i < particles.size(); ++i) {
    if (!has_pressure(particles.kind[i])) continue;
    double n = 0;
    Vec<dim> moment = Vec<dim>::Zero();
    neighbors.each_weighted(particles, i, [&](int, const Vec<dim>& x_ij, double, double w) {
      n += w;
      moment += w * x_ij;
    });
    particles.n[i] = n;
    const bool thin = n < criterion.beta * n0 && moment.norm() > criterion.delta * n;
    particles.free_surface[i] = static_cast<std::uint8_t>(thin || neighbors.count(i) <= few<dim>);
  }
}

template <int dim>
std::vector<double> density_and_lone_particles(Particles<dim>& particles, const Neighbors<dim>& neighbors) {
  std::vector<double> smooth_density(particles.x.size());
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (int i = 0; i < particles.size(); ++i) {
    if (!has_pressure(particles.kind[i])) continue;
    double n = 0;
    double smooth = 1;
    bool wet = particles.kind[i] == Kind::fluid;
    neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>&, double, double w) {
      n += w;
      smooth += smooth_share(w);
      wet = wet || particles.kind[j] == Kind::fluid;
    });
    particles.n[i] = n;
    smooth_density[static_cast<std::size_t>(i)] = smooth;
    particles.free_surface[i] = static_cast<std::uint8_t>(!wet || neighbors.count(i) <= few<dim>);
  }
  return smooth_density;
}

template std::vector<double> density_and_lone_particles<2>(Particles<2>&, const Neighbors<2>&);
template std::vector<double> density_and_lone_particles<3>(Particles<3>&, const Neighbors<3>&);
template void density_and_free_surface<2>(Particles<2>&, const Neighbors<2>&, double,
                                          const FreeSurfaceCriterion&);
template void density_and_free_surface<3>(Particles<3>&, const Neighbors<3>&, double,
                                          const FreeSurfaceCriterion&);

}  // namespace cosurge::fluid
