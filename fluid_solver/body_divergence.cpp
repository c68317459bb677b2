#include "fluid_solver/body_divergence.hpp"

#include <cmath>

#include "fluid_solver/operators.hpp"

namespace cosurge::fluid {

template <int dim>
std::vector<double> body_divergence(const BodiesInWater<dim>& bodies, const Field& motion) {
  const Particles<dim>& particles = bodies.particles;
  std::vector<Vec<dim>> velocity(particles.u.size(), Vec<dim>::Zero());
  for (std::size_t k = 0; k < bodies.body_place.size(); ++k)
    velocity[static_cast<std::size_t>(bodies.body_place[k])] = motion.col(bodies.seen[k]);
  for (const Cover& cover : bodies.covers) velocity[cover.wall] = velocity[cover.by];
  std::vector<double> divergence =
      bodies.poisson.divergence_by_bodies(particles, velocity, bodies.neighbors.grid());
  const std::vector<std::int32_t>& unknowns = bodies.poisson.unknowns();
  for (std::size_t m = 0; m < unknowns.size(); ++m)
    if (std::isnan(divergence[m]))
      divergence[m] = near_divergence<dim>(particles, velocity, bodies.neighbors, unknowns[m],
                                           bodies.reference.n0, Vec<dim>::Zero());
  return divergence;
}

template std::vector<double> body_divergence<2>(const BodiesInWater<2>&, const Field&);
template std::vector<double> body_divergence<3>(const BodiesInWater<3>&, const Field&);

}  // namespace cosurge::fluid
