#include "fluid_solver/covered_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cosurge::fluid {
namespace {

// In spacings.
constexpr double closed_gap = 0.25;
constexpr double open_gap = 0.5;
// Largest distance of a covering particle from the face's normal: on a lattice that is shifted by half a
// spacing along each axis, the nearest particle is at most this far from it.
constexpr double beside = 0.55;

/// How far a particle at `way` from the point is along a face's normal [spacings]; infinity where it does not
/// lie before the face.
template <int dim>
double ahead(const Vec<dim>& way, const Vec<dim>& normal, double spacing) {
  const double along = way.dot(normal);
  const bool before = along > 0 && (way - along * normal).norm() <= beside * std::sqrt(dim - 1.0) * spacing;
  return before ? along / spacing : std::numeric_limits<double>::infinity();
}

double open_share(double ahead) {
  return std::clamp((ahead - 1 - closed_gap) / (open_gap - closed_gap), 0.0, 1.0);
}

}  // namespace

template <int dim>
std::vector<Openness<dim>> CoveredFaces<dim>::find(const Bodies<dim>& bodies, const Faces<dim>& faces,
                                                   const std::vector<int>& place,
                                                   const Particles<dim>& particles,
                                                   const Neighbors<dim>& neighbors, double spacing) {
  std::vector<int> body(static_cast<std::size_t>(particles.size()), -1);
  for (int k = 0; k < bodies.points(); ++k) body[static_cast<std::size_t>(place[k])] = bodies.body(k);
  std::vector<Openness<dim>> open(static_cast<std::size_t>(bodies.points()));
  film_.resize(open.size(), 0);
  for (int k = 0; k < bodies.points(); ++k) {
    if (!bodies.wet(k)) continue;
    const Mat<dim>& J = faces.cofactor[k];
    bool narrow = false, water = false;
    neighbors.each(particles, place[k], [&](int j, const Vec<dim>& way, double) {
      water = water || particles.kind[j] == Kind::fluid;
      const bool wall = particles.kind[j] == Kind::wall || particles.kind[j] == Kind::dummy;
      if (!wall && (body[j] < 0 || body[j] == bodies.body(k))) return;
      for (int axis = 0; axis < dim; ++axis) {
        const Vec<dim> normal = J.col(axis).normalized();
        const double above = ahead<dim>(way, normal, spacing), below = ahead<dim>(way, -normal, spacing);
        const LatticeFaces<dim>& wet = bodies.lattice_faces(k);
        narrow = narrow || (wet.above[axis] > 0 && above < 2) || (wet.below[axis] > 0 && below < 2);
        open[k].above[axis] = std::min(open[k].above[axis], open_share(above));
        open[k].below[axis] = std::min(open[k].below[axis], open_share(below));
      }
    });
    if (!narrow) film_[k] = water ? 1 : 0;
  }
  return open;
}

template class CoveredFaces<2>;
template class CoveredFaces<3>;

}  // namespace cosurge::fluid
