#include "fluid_solver/pressure/poisson_equation.hpp"

#include <cmath>

#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

constexpr int expected_entries(int dim) {
  return dim == 2 ? 120 : 900;
}  // whole runs on the lattice, and disorder
constexpr double facing_away = -0.5;  // cosine between a wet face and the way to a neighbour behind the body
constexpr float edge = 1e-6F;         // weight of a site on the edge r = r_e by rounding: it does not count

template <int dim>
bool behind(const Vec<dim>& area, const Vec<dim>& way, double r) {
  return area.dot(way) < facing_away * area.norm() * r;
}

/// Eq. (1) in single precision from a squared distance; 0 at r = 0, the particle itself.
inline float weight_of(float r2, float re) {
  const float w = re / std::sqrt(r2) - 1.0F;
  return r2 > 0 && w > edge ? w : 0.0F;
}

}  // namespace

template <int dim>
PoissonEquation<dim>::PoissonEquation(const PoissonParameters<dim>& parameters)
    : parameters_(parameters), reference_(reference_values<dim>(parameters.re, parameters.spacing)) {}

template <int dim>
void PoissonEquation<dim>::number_unknowns(const Particles<dim>& particles, const CellGrid<dim>& grid) {
  place_.clear();
  other_.clear();
  rank_.clear();
  wet_ = {0};
  cells_.first.clear();
  cells_.cell.clear();
  CellIndex<dim> last = CellIndex<dim>::Constant(-1);
  for (int i = 0; i < particles.size(); ++i) {
    const auto number = static_cast<std::int32_t>(place_.size());
    rank_.push_back(number);
    if (!has_pressure(particles.kind[i]) || particles.free_surface[i] != 0) {
      other_.push_back(i);
      continue;
    }
    const CellIndex<dim> cell = grid.cell_of(particles.x[i]);
    if (cell != last) {
      last = cell;
      cells_.first.push_back(number);
      cells_.cell.push_back({cell[0], cell[1], dim == 3 ? cell[dim - 1] : 0});
    }
    place_.push_back(i);
    wet_.push_back(wet_.back() + (particles.kind[i] == Kind::body_surface ? 1 : 0));
  }
  const auto size = static_cast<std::int32_t>(place_.size());
  rank_.push_back(size);
  cells_.first.push_back(size);
  for (int k = 0; k < dim; ++k) {
    x_[k].resize(place_.size() + Matrix::lanes);
    for (std::size_t m = 0; m < place_.size(); ++m) x_[k][m] = particles.x[place_[m]][k];
  }
}

template <int dim>
void PoissonEquation<dim>::assemble(const Particles<dim>& particles, const CellGrid<dim>& grid,
                                    const std::vector<double>& source, const std::vector<Vec<dim>>& areas,
                                    double dt) {
  number_unknowns(particles, grid);
  const double scale = reference_.lambda0 * reference_.n0 / (2 * dim);
  const double stiffness = scale * parameters_.compressibility * parameters_.density / (dt * dt);
  const int reach = static_cast<int>(std::ceil(parameters_.re * (1 - 1e-9) / grid.cell_size()));
  const Assembly assembly{.particles = particles, .grid = grid, .areas = areas, .reach = reach};
  A_.runs_per_row = static_cast<int>(std::pow(2 * reach + 1, dim - 1));
  A_.run.resize(place_.size() * static_cast<std::size_t>(A_.runs_per_row));
  A_.diagonal.resize(place_.size());
  b_.resize(place_.size());
  const auto row = [&](int k, std::int64_t begin) {
    RowSums sums;
    const std::int64_t length = fill_row(assembly, k, begin, sums);
    A_.diagonal[k] = stiffness + sums.diagonal;
    b_[k] = -scale * source[place_[k]] + sums.wall;
    return length;
  };
  const auto room = [&](std::int64_t entries) { A_.weight.resize(static_cast<std::size_t>(entries)); };
  A_.rows.fill(static_cast<int>(place_.size()), expected_entries(dim), most_entries(dim), room, row);
}

/// Fills row k from `begin` on, run by run, and returns how many weights it has.
template <int dim>
std::int64_t PoissonEquation<dim>::fill_row(const Assembly& assembly, int k, std::int64_t begin,
                                            RowSums& sums) {
  const int i = place_[k];
  Matrix::Run* run = A_.run.data() + static_cast<std::ptrdiff_t>(k) * A_.runs_per_row;
  Matrix::Run* const end = run + A_.runs_per_row;
  std::int64_t length = 0;
  assembly.grid.ranges(assembly.grid.cell_of(assembly.particles.x[i]), assembly.reach,
                       [&](std::int32_t first, std::int32_t last) {
                         const int entries =
                             fill_run(assembly, i, rank_[first], rank_[last], begin + length, *run, sums);
                         add_others(assembly, i, first - rank_[first], last - rank_[last], sums);
                         length += entries;
                         if (entries > 0) ++run;
                       });
  if (run != end) run->length = 0;
  return length;
}

/// Weights between particle i and the unknowns first ... last, trimmed to those that are not zero and filled
/// up to whole lanes. Returns how many are kept.
template <int dim>
int PoissonEquation<dim>::fill_run(const Assembly& assembly, int i, int first, int last, std::int64_t begin,
                                   Matrix::Run& run, RowSums& sums) {
  float* const weights = A_.weight.data() + begin;
  const Vec<dim>& x_i = assembly.particles.x[i];
  const auto re = static_cast<float>(parameters_.re);
  // Whole lanes, beyond the run too: a rest of single numbers would cost as much as the lanes.
  const int whole = first + (last - first + Matrix::lanes - 1) / Matrix::lanes * Matrix::lanes;
  for (int block = first; block < whole; block += Matrix::lanes) {
#pragma omp simd simdlen(8)
    for (int m = block; m < block + Matrix::lanes; ++m) {
      float r2 = 0;
      for (int k = 0; k < dim; ++k) {
        const auto d = static_cast<float>(x_[k][m] - x_i[k]);
        r2 += d * d;
      }
      weights[m - first] = weight_of(r2, re);
    }
  }
  const bool beside_body = assembly.particles.kind[i] == Kind::body_surface || wet_[last] > wet_[first];
  if (beside_body) hide_behind_bodies(assembly, i, first, last, weights, sums);
  int from = 0;
  int to = last - first;
  while (from < to && weights[from] == 0) ++from;
  while (to > from && weights[to - 1] == 0) --to;
  if (from == to) return 0;
  double diagonal = 0;
  for (int m = from; m < to; ++m) diagonal += static_cast<double>(weights[m]);
  sums.diagonal += diagonal;

  const int size = static_cast<int>(place_.size());
  const int length = std::min(size, (to - from + Matrix::lanes - 1) / Matrix::lanes * Matrix::lanes);
  const int start = std::min(first + from, size - length);  // the last columns are filled up in front
  const int shift = first + from - start;
  std::memmove(weights + shift, weights + from, static_cast<std::size_t>(to - from) * sizeof(float));
  std::fill(weights, weights + shift, 0.0F);
  std::fill(weights + shift + (to - from), weights + length, 0.0F);
  run = {.first = start, .length = length};
  return length;
}

/// Takes out the pairs that see each other through a body; for both, the other side is a wall.
template <int dim>
void PoissonEquation<dim>::hide_behind_bodies(const Assembly& assembly, int i, int first, int last,
                                              float* weights, RowSums& sums) const {
  const Particles<dim>& particles = assembly.particles;
  const bool on_body = particles.kind[i] == Kind::body_surface;
  for (int m = first; m < last; ++m) {
    if (weights[m - first] == 0) continue;
    const int j = place_[m];
    const Vec<dim> x_ij = particles.x[j] - particles.x[i];
    const double r = x_ij.norm();
    const bool hidden = (on_body && behind<dim>(assembly.areas[i], x_ij, r)) ||
                        (particles.kind[j] == Kind::body_surface && behind<dim>(assembly.areas[j], -x_ij, r));
    if (!hidden) continue;
    sums.wall +=
        static_cast<double>(weights[m - first]) * parameters_.density * parameters_.gravity.dot(x_ij);
    weights[m - first] = 0;
  }
}

/// Free surface (P = 0), and walls by the Neumann condition: the particles first ... last of those without an
/// unknown.
template <int dim>
void PoissonEquation<dim>::add_others(const Assembly& assembly, int i, int first, int last,
                                      RowSums& sums) const {
  const Particles<dim>& particles = assembly.particles;
  const bool on_body = particles.kind[i] == Kind::body_surface;
  for (int m = first; m < last; ++m) {
    const int j = other_[m];
    const Vec<dim> x_ij = particles.x[j] - particles.x[i];
    const auto w = static_cast<double>(
        weight_of(static_cast<float>(x_ij.squaredNorm()), static_cast<float>(parameters_.re)));
    if (w == 0) continue;
    const double r = x_ij.norm();
    const bool wall = !has_pressure(particles.kind[j]) ||
                      (on_body && behind<dim>(assembly.areas[i], x_ij, r)) ||
                      (particles.kind[j] == Kind::body_surface && behind<dim>(assembly.areas[j], -x_ij, r));
    if (wall)
      sums.wall += w * parameters_.density * parameters_.gravity.dot(x_ij);
    else
      sums.diagonal += w;
  }
}

template class PoissonEquation<2>;
template class PoissonEquation<3>;

}  // namespace cosurge::fluid
