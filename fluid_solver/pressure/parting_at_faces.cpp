#include "fluid_solver/pressure/parting_at_faces.hpp"

#include "fluid_solver/faces.hpp"
#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

/// Calls visit(j, x_ij, w) for the particles within `re` of particle i.
template <int dim, typename Visit>
void each_seen(const Particles<dim>& particles, const CellGrid<dim>& grid, int i, double re, Visit&& visit) {
  grid.ranges(grid.cell_of(particles.x[i]), grid.reach(re), [&](std::int32_t first, std::int32_t last) {
    for (std::int32_t j = first; j < last; ++j) {
      const Vec<dim> x_ij = particles.x[j] - particles.x[i];
      const double square = x_ij.squaredNorm();
      if (square > re * re) continue;  // about half of the candidates
      const double w = weight_of(static_cast<float>(square), static_cast<float>(re));
      if (w != 0) visit(j, x_ij, w);
    }
  });
}

/// Sum for a water particle.
template <int dim>
double parting_of_water(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                        const CellGrid<dim>& grid, int i, double re, const Vec<dim>& kick) {
  double sum = 0;
  each_seen(particles, grid, i, re, [&](int j, const Vec<dim>& x_ij, double w) {
    const Vec<dim> u_ij = velocity[j] - velocity[i];
    sum +=
        w * (particles.kind[j] == Kind::fluid ? u_ij.dot(x_ij)
                                              : across_face<dim>(u_ij + kick, particles.normal[j]).dot(x_ij));
  });
  return sum;
}

/// Sum for a point of a wall or body, from the water before it and other walls. Wall points that the face
/// moves along stand for the water there; faces beside the point count as for a water particle.
template <int dim>
double parting_of_face(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                       const CellGrid<dim>& grid, int i, double re, double face_factor,
                       const Vec<dim>& kick) {
  const Vec<dim>& n = particles.normal[i];
  const bool on_body = of_body(particles.kind[i]);
  double ahead = 0, beside = 0, weights = 0;
  Vec<dim> along = Vec<dim>::Zero(), centre = Vec<dim>::Zero();
  each_seen(particles, grid, i, re, [&](int j, const Vec<dim>& x_ij, double w) {
    const Vec<dim> u_ij = velocity[j] - velocity[i];
    if (particles.kind[j] != Kind::fluid) {
      if (on_body && of_body(particles.kind[j])) return;
      const Vec<dim> across = across_face<dim>(u_ij, n);
      ahead += w * across.dot(x_ij);
      beside += w * across_face<dim>(u_ij - across, particles.normal[j]).dot(x_ij);
      return;
    }
    if (on_body && behind_face<dim>(n, x_ij, x_ij.norm())) return;
    const Vec<dim> u = u_ij - kick;
    ahead += w * u.dot(x_ij);
    weights += w;
    along += w * (u - across_face<dim>(u, n));
    centre += w * x_ij;
  });
  if (weights > 0) ahead -= along.dot(centre) / weights;
  return face_factor * ahead + beside;
}

}  // namespace

template <int dim>
double parting_at_faces(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                        const CellGrid<dim>& grid, int i, double re, double face_factor,
                        const Vec<dim>& kick) {
  return particles.kind[i] == Kind::fluid
             ? parting_of_water(particles, velocity, grid, i, re, kick)
             : parting_of_face(particles, velocity, grid, i, re, face_factor, kick);
}

template double parting_at_faces<2>(const Particles<2>&, const std::vector<Vec<2>>&, const CellGrid<2>&, int,
                                    double, double, const Vec<2>&);
template double parting_at_faces<3>(const Particles<3>&, const std::vector<Vec<3>>&, const CellGrid<3>&, int,
                                    double, double, const Vec<3>&);

}  // namespace cosurge::fluid
