#include "fluid_solver/covered_faces.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge::fluid {
namespace {

// In spacings.
constexpr double closed_gap = 0.25;
constexpr double open_gap = 0.5;
// How far a particle may be beside a face's normal and still cover the face: on a lattice that is off by half
// a spacing along each axis none is farther.
constexpr double beside = 0.55;

/// Share of a face that particle j leaves open, which lies at `way` from the point behind the face.
template <int dim>
double left_open(const Vec<dim>& way, const Vec<dim>& normal, double spacing) {
  const double along = way.dot(normal);
  if (along <= 0 || (way - along * normal).norm() > beside * std::sqrt(dim - 1.0) * spacing) return 1;
  return std::clamp((along / spacing - 1 - closed_gap) / (open_gap - closed_gap), 0.0, 1.0);
}

}  // namespace

template <int dim>
std::vector<Openness<dim>> open_faces(const Bodies<dim>& bodies, const Faces<dim>& faces,
                                      const std::vector<int>& place, const Particles<dim>& particles,
                                      const Neighbors<dim>& neighbors, double spacing) {
  std::vector<int> body(static_cast<std::size_t>(particles.size()), -1);
  for (int k = 0; k < bodies.points(); ++k) body[static_cast<std::size_t>(place[k])] = bodies.body(k);
  std::vector<Openness<dim>> open(static_cast<std::size_t>(bodies.points()));
  for (int k = 0; k < bodies.points(); ++k) {
    if (!bodies.wet(k)) continue;
    const Mat<dim>& J = faces.cofactor[k];
    neighbors.each(particles, place[k], [&](int j, const Vec<dim>& way, double) {
      const bool wall = particles.kind[j] == Kind::wall || particles.kind[j] == Kind::dummy;
      if (!wall && (body[j] < 0 || body[j] == bodies.body(k))) return;
      for (int axis = 0; axis < dim; ++axis) {
        const Vec<dim> normal = J.col(axis).normalized();
        open[k].above[axis] = std::min(open[k].above[axis], left_open<dim>(way, normal, spacing));
        open[k].below[axis] = std::min(open[k].below[axis], left_open<dim>(way, -normal, spacing));
      }
    });
  }
  return open;
}

template std::vector<Openness<2>> open_faces(const Bodies<2>&, const Faces<2>&, const std::vector<int>&,
                                             const Particles<2>&, const Neighbors<2>&, double);
template std::vector<Openness<3>> open_faces(const Bodies<3>&, const Faces<3>&, const std::vector<int>&,
                                             const Particles<3>&, const Neighbors<3>&, double);

}  // namespace cosurge::fluid
