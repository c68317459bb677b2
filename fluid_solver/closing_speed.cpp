#include "fluid_solver/closing_speed.hpp"

#include <algorithm>

#include "fluid_solver/rigid_motion.hpp"

namespace cosurge::fluid {
namespace {

/// Rigid motion of each body that is not held at rest; at rest otherwise.
template <int dim>
std::vector<RigidMotion<dim>> motions(const DrivenBodies<dim>& driven, const Particles<dim>& particles) {
  std::vector<std::vector<Vec<dim>>> x(driven.bodies.count());
  std::vector<std::vector<Vec<dim>>> u(driven.bodies.count());
  for (int k = 0; k < driven.bodies.points(); ++k) {
    const auto body = static_cast<std::size_t>(driven.bodies.body(k));
    if (driven.bodies.held_at_rest(body)) continue;
    x[body].push_back(particles.x[driven.place[k]]);
    u[body].push_back(particles.u[driven.place[k]]);
  }
  std::vector<RigidMotion<dim>> found(driven.bodies.count());
  for (std::size_t b = 0; b < found.size(); ++b)
    if (!x[b].empty()) found[b] = rigid_motion<dim>(x[b], u[b]);
  return found;
}

}  // namespace

template <int dim>
double closing_speed(const DrivenBodies<dim>& driven, const Particles<dim>& particles,
                     const Neighbors<dim>& neighbors, const Walls<dim>& walls, double end, double dt) {
  const std::vector<RigidMotion<dim>> motion = motions(driven, particles);
  double fastest = 0;
  for (int k = 0; k < driven.bodies.points(); ++k) {
    const std::int32_t i = driven.place[k];
    const auto body = static_cast<std::size_t>(driven.bodies.body(k));
    if (driven.bodies.held_at_rest(body) || particles.kind[i] != Kind::body_surface) continue;
    const Vec<dim> u = motion[body].at(particles.x[i]);
    const double own = (u - walls.tank_velocity(particles.x[i], end, dt)).norm();
    if (own <= fastest) continue;
    neighbors.each(particles, i, [&](int j, const Vec<dim>& x_ij, double) {
      if (particles.kind[j] != Kind::fluid || x_ij.dot(driven.normal[k]) <= 0) return;
      fastest = std::max(fastest, std::min(own, (u - particles.u[j]).dot(driven.normal[k])));
    });
  }
  return fastest;
}

template double closing_speed<2>(const DrivenBodies<2>&, const Particles<2>&, const Neighbors<2>&,
                                 const Walls<2>&, double, double);
template double closing_speed<3>(const DrivenBodies<3>&, const Particles<3>&, const Neighbors<3>&,
                                 const Walls<3>&, double, double);

}  // namespace cosurge::fluid
