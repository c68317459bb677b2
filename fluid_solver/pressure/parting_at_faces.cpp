#include "fluid_solver/pressure/parting_at_faces.hpp"

#include "fluid_solver/faces.hpp"
#include "fluid_solver/seen_faces.hpp"
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
                        const CellGrid<dim>& grid, int i, const FaceRule<dim>& rule) {
  SeenFaces<dim> faces(rule.spacing);
  const auto from_wall = [&](int j, const Vec<dim>& x_ij, const Vec<dim>& n) {
    return across_face<dim>(velocity[j] - velocity[i] + rule.kick, n).dot(x_ij);
  };
  double from_water = 0, from_walls = 0;
  each_seen(particles, grid, i, rule.re, [&](int j, const Vec<dim>& x_ij, double w) {
    if (particles.kind[j] == Kind::fluid) {
      from_water += w * (velocity[j] - velocity[i]).dot(x_ij);
      return;
    }
    faces.add(particles.normal[j], x_ij, has_pressure(particles.kind[j]));
    from_walls += w * from_wall(j, x_ij, particles.normal[j]);
  });
  if (!faces.at_edge()) return from_water + from_walls;
  from_walls = 0;
  each_seen(particles, grid, i, rule.re, [&](int j, const Vec<dim>& x_ij, double w) {
    if (particles.kind[j] != Kind::fluid)
      from_walls += w * from_wall(j, x_ij, faces.normal(particles.normal[j]));
  });
  return from_water + from_walls;
}

/// Sum for a point of a wall or body, from the water before it and other walls. Wall points that the face
/// moves along stand for the water there; faces beside the point count as for a water particle.
template <int dim>
double parting_of_face(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                       const CellGrid<dim>& grid, int i, const FaceRule<dim>& rule) {
  const Vec<dim>& n = particles.normal[i];
  const bool on_body = of_body(particles.kind[i]);
  double ahead = 0, beside = 0, weights = 0;
  Vec<dim> along = Vec<dim>::Zero(), centre = Vec<dim>::Zero();
  each_seen(particles, grid, i, rule.re, [&](int j, const Vec<dim>& x_ij, double w) {
    const Vec<dim> u_ij = velocity[j] - velocity[i];
    if (particles.kind[j] != Kind::fluid) {
      if (on_body && of_body(particles.kind[j])) return;
      const Vec<dim> across = across_face<dim>(u_ij, n);
      ahead += w * across.dot(x_ij);
      beside += w * across_face<dim>(u_ij - across, particles.normal[j]).dot(x_ij);
      return;
    }
    if (n.dot(x_ij) < 0) return;
    const Vec<dim> u = u_ij - rule.kick;
    ahead += w * u.dot(x_ij);
    weights += w;
    along += w * (u - across_face<dim>(u, n));
    centre += w * x_ij;
  });
  if (weights > 0) ahead -= along.dot(centre) / weights;
  return rule.face_factor * ahead + beside;
}

}  // namespace

template <int dim>
double parting_at_faces(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                        const CellGrid<dim>& grid, int i, const FaceRule<dim>& rule) {
  return particles.kind[i] == Kind::fluid ? parting_of_water(particles, velocity, grid, i, rule)
                                          : parting_of_face(particles, velocity, grid, i, rule);
}

template double parting_at_faces<2>(const Particles<2>&, const std::vector<Vec<2>>&, const CellGrid<2>&, int,
                                    const FaceRule<2>&);
template double parting_at_faces<3>(const Particles<3>&, const std::vector<Vec<3>>&, const CellGrid<3>&, int,
                                    const FaceRule<3>&);

}  // namespace cosurge::fluid
