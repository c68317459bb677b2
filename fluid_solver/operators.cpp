#include "fluid_solver/operators.hpp"

#include <Eigen/LU>

#include "fluid_solver/faces.hpp"
#include "fluid_solver/seen_faces.hpp"
#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {

template <int dim>
Vec<dim> gradient_p_min(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i, double n0) {
  // One pass: sum (P_j - P_min) c_j = sum P_j c_j - P_min sum c_j with c_j = w x_ij / r^2, taken relative to
  // P_i.
  const double p_i = particles.p[i];
  double p_min = 0;
  Vec<dim> sum = Vec<dim>::Zero();
  Vec<dim> directions = Vec<dim>::Zero();
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double w) {
    if (!has_pressure(particles.kind[j])) return;
    const double p_ij = particles.p[j] - p_i;
    p_min = std::min(p_min, p_ij);
    const Vec<dim> direction = w / (r * r) * x_ij;
    sum += p_ij * direction;
    directions += direction;
  });
  return dim / n0 * (sum - p_min * directions);
}

template <int dim>
Vec<dim> gradient_conserving(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                             double n0, const Vec<dim>& rho_g, double lowest) {
  const double p_i = particles.p[i];
  Vec<dim> sum = Vec<dim>::Zero();
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double w) {
    const double p_j =
        has_pressure(particles.kind[j]) ? particles.p[j] : std::max(lowest, p_i + rho_g.dot(x_ij));
    sum += (p_j + p_i) * w / (r * r) * x_ij;
  });
  return dim / n0 * sum;
}

template <int dim>
CorrectedGradient<dim> gradient_corrected(const Particles<dim>& particles, const Neighbors<dim>& neighbors,
                                          int i, double n0) {
  const double p_i = particles.p[i];
  double lowest = p_i;
  Vec<dim> sum = Vec<dim>::Zero(), directions = Vec<dim>::Zero();
  Mat<dim> moments = Mat<dim>::Zero();
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double w) {
    const Vec<dim> direction = w / (r * r) * x_ij;
    directions += direction;
    if (!has_pressure(particles.kind[j])) return;
    lowest = std::min(lowest, particles.p[j]);
    sum += (particles.p[j] - p_i) * direction;
    moments += direction * x_ij.transpose();
  });
  moments *= dim / n0;  // identity on the lattice
  constexpr double flat = 0.05;
  return {.gradient = dim / n0 * (moments.determinant() > flat ? Vec<dim>(moments.inverse() * sum) : sum),
          .repulsion = dim / n0 * (p_i - lowest) * directions};
}

template <int dim>
Vec<dim> even_out(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i, double n0) {
  Vec<dim> crowding = Vec<dim>::Zero();
  bool inner = particles.free_surface[i] == 0;
  neighbors.each(particles, i, [&](int j, const Vec<dim>& x_ij, double r) {
    inner = inner && (particles.kind[j] != Kind::fluid || particles.free_surface[j] == 0);
    crowding += weight(r, neighbors.re()) / r * x_ij;
  });
  if (!inner) return Vec<dim>::Zero();
  return -dim / n0 * crowding;
}

template <int dim>
double near_divergence(const Particles<dim>& particles, const std::vector<Vec<dim>>& velocity,
                       const Neighbors<dim>& neighbors, int i, double n0, const Vec<dim>& kick) {
  const auto kicked = [&](int k) { return particles.kind[k] == Kind::fluid ? 0.0 : 1.0; };
  const bool on_body = of_body(particles.kind[i]);
  double sum = 0;
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double w) {
    if (on_body && of_body(particles.kind[j])) return;
    const Vec<dim> u_ij = velocity[j] - velocity[i] + (kicked(j) - kicked(i)) * kick;
    sum += u_ij.dot(x_ij) * w / (r * r);
  });
  return dim / n0 * sum;
}

/// approach_speed() of water particle i.
template <int dim>
double approach_of_water(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                         const Vec<dim>& kick, double spacing) {
  SeenFaces<dim> faces(spacing);
  const auto to_wall = [&](int j, const Vec<dim>& x_ij, double r, const Vec<dim>& n) {
    return -across_face<dim>(particles.u[j] - particles.u[i] + kick, n).dot(x_ij) / r;
  };
  double to_water = 0, to_walls = 0;
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double) {
    if (particles.kind[j] == Kind::fluid) {
      to_water = std::max(to_water, (particles.u[i] - particles.u[j]).dot(x_ij) / r);
      return;
    }
    faces.add(particles.normal[j], x_ij, has_pressure(particles.kind[j]));
    to_walls = std::max(to_walls, to_wall(j, x_ij, r, particles.normal[j]));
  });
  if (!faces.at_edge()) return std::max(to_water, to_walls);
  to_walls = 0;
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double) {
    if (particles.kind[j] != Kind::fluid)
      to_walls = std::max(to_walls, to_wall(j, x_ij, r, faces.normal(particles.normal[j])));
  });
  return std::max(to_water, to_walls);
}

template <int dim>
double approach_speed(const Particles<dim>& particles, const Neighbors<dim>& neighbors, int i,
                      const Vec<dim>& kick, double spacing) {
  if (particles.kind[i] == Kind::fluid) return approach_of_water(particles, neighbors, i, kick, spacing);
  const Vec<dim>& n = particles.normal[i];
  double fastest = 0;
  neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double) {
    if (particles.kind[j] != Kind::fluid || n.dot(x_ij) < 0) return;
    const Vec<dim> u_ij = across_face<dim>(particles.u[j] - particles.u[i] - kick, n);
    fastest = std::max(fastest, -u_ij.dot(x_ij) / r);
  });
  return fastest;
}

template Vec<2> gradient_p_min<2>(const Particles<2>&, const Neighbors<2>&, int, double);
template Vec<3> gradient_p_min<3>(const Particles<3>&, const Neighbors<3>&, int, double);
template Vec<2> gradient_conserving<2>(const Particles<2>&, const Neighbors<2>&, int, double, const Vec<2>&,
                                       double);
template Vec<3> gradient_conserving<3>(const Particles<3>&, const Neighbors<3>&, int, double, const Vec<3>&,
                                       double);
template CorrectedGradient<2> gradient_corrected<2>(const Particles<2>&, const Neighbors<2>&, int, double);
template CorrectedGradient<3> gradient_corrected<3>(const Particles<3>&, const Neighbors<3>&, int, double);
template Vec<2> even_out<2>(const Particles<2>&, const Neighbors<2>&, int, double);
template Vec<3> even_out<3>(const Particles<3>&, const Neighbors<3>&, int, double);
template double near_divergence<2>(const Particles<2>&, const std::vector<Vec<2>>&, const Neighbors<2>&, int,
                                   double, const Vec<2>&);
template double near_divergence<3>(const Particles<3>&, const std::vector<Vec<3>>&, const Neighbors<3>&, int,
                                   double, const Vec<3>&);
template double approach_speed<2>(const Particles<2>&, const Neighbors<2>&, int, const Vec<2>&, double);
template double approach_speed<3>(const Particles<3>&, const Neighbors<3>&, int, const Vec<3>&, double);

}  // namespace cosurge::fluid
