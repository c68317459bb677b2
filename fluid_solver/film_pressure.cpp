#include "fluid_solver/film_pressure.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "fluid_solver/point_hash.hpp"

namespace cosurge::fluid {
namespace {

/// Whether a point has a wet face that is open as a whole.
template <int dim>
bool reaches_the_water(const LatticeFaces<dim>& wet, const Openness<dim>& open) {
  for (int axis = 0; axis < dim; ++axis)
    if ((wet.above[axis] > 0 && open.above[axis] == 1) || (wet.below[axis] > 0 && open.below[axis] == 1))
      return true;
  return false;
}

}  // namespace

template <int dim>
void FilmPressure<dim>::find(const Bodies<dim>& bodies, const Faces<dim>& faces,
                             const std::vector<Openness<dim>>& open, const std::vector<char>& film) {
  area_.clear();
  points_.clear();
  load_.clear();
  for (int k = 0; k < bodies.points(); ++k) {
    if (!bodies.wet(k) || film[k] == 0) continue;
    const LatticeFaces<dim>& wet = bodies.lattice_faces(k);
    const Vec<dim> above = wet.above.cwiseProduct(Vec<dim>::Ones() - open[k].above);
    const Vec<dim> below = wet.below.cwiseProduct(Vec<dim>::Ones() - open[k].below);
    if ((above + below).isZero()) continue;
    area_.resize(static_cast<std::size_t>(bodies.points()), Vec<dim>::Zero());
    area_[k] = faces.cofactor[k] * (above - below);
    if (!reaches_the_water(wet, open[k])) points_.push_back(k);
  }
}

template <int dim>
void FilmPressure<dim>::solve(const Bodies<dim>& bodies, const std::vector<std::int32_t>& place,
                              const Particles<dim>& particles, const Vec<dim>& slope, double spacing) {
  load_.clear();
  if (area_.empty()) return;
  constexpr double reach = 1.5;         // spacings: the next points along a face and around an edge
  constexpr double insulation = 1e-12;  // keeps the equation of a film without any open point regular
  std::vector<int> unknown(static_cast<std::size_t>(bodies.points()), -1);
  for (std::size_t m = 0; m < points_.size(); ++m) unknown[points_[m]] = static_cast<int>(m);
  const auto x = [&](int k) -> const Vec<dim>& { return particles.x[place[k]]; };
  const auto head = [&](int k) { return particles.p[place[k]] - slope.dot(x(k)); };
  const auto size = static_cast<Eigen::Index>(points_.size());
  Eigen::VectorXd heads = Eigen::VectorXd::Zero(size), right = Eigen::VectorXd::Zero(size);
  std::vector<Eigen::Triplet<double>> entries;
  PointHash<dim> around(reach * spacing);
  std::vector<int> surface;
  for (int k = 0; k < bodies.points(); ++k)
    if (bodies.wet(k)) around.add(x(k)), surface.push_back(k);
  for (int m = 0; m < size; ++m) {
    const int k = points_[static_cast<std::size_t>(m)];
    double sum = insulation / (spacing * spacing);
    around.near(x(k), [&](std::int32_t n, double r) {
      const int j = surface[static_cast<std::size_t>(n)];
      if (j == k || bodies.body(j) != bodies.body(k)) return;
      const double weight = 1 / (r * r);
      sum += weight;
      if (unknown[j] >= 0)
        entries.emplace_back(m, unknown[j], -weight);
      else
        right[m] += weight * head(j);
    });
    entries.emplace_back(m, m, sum);
  }
  if (size > 0) {
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    heads = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  }
  load_.assign(area_.size(), Vec<dim>::Zero());
  for (int k = 0; k < bodies.points(); ++k) {
    const double area = area_[k].norm();
    if (area == 0) continue;
    const Vec<dim> face = x(k) + 0.5 * spacing / area * area_[k];
    const double at_face = (unknown[k] >= 0 ? heads[unknown[k]] : head(k)) + slope.dot(face);
    load_[k] = -std::max(0.0, at_face) * area_[k];
  }
}

template <int dim>
std::vector<int> FilmPressure<dim>::particles_in_gap(const std::vector<std::int32_t>& place,
                                                     const Particles<dim>& particles,
                                                     const Neighbors<dim>& neighbors, double spacing) const {
  constexpr double near = 1.2;  // spacings
  std::vector<int> found;
  for (const int k : points_)
    neighbors.each(particles, place[k], [&](int i, const Vec<dim>&, double r) {
      if (particles.kind[i] == Kind::fluid && r < near * spacing) found.push_back(i);
    });
  return found;
}

template class FilmPressure<2>;
template class FilmPressure<3>;

}  // namespace cosurge::fluid
