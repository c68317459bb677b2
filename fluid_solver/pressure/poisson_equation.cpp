#include "fluid_solver/pressure/poisson_equation.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "fluid_solver/faces.hpp"
#include "fluid_solver/pressure/parting_at_faces.hpp"
#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

constexpr int stretch = 64;  // candidates tested at a time: the number of bits of a word
constexpr int expected_blocks(int dim) { return dim == 2 ? 12 : 90; }  // on the lattice, and disorder

/// One bit for each of `lanes` numbers: 1 where the number is not zero.
inline std::uint32_t not_zero(const float* numbers) {
  using Bits = std::int32_t __attribute__((vector_size(8 * sizeof(std::int32_t))));
  Floats values;
  std::memcpy(&values, numbers, sizeof values);
  const Bits bits = (values != 0.0F) & Bits{1, 2, 4, 8, 16, 32, 64, 128};
  std::int32_t all = 0;
  for (int lane = 0; lane < Matrix::lanes; ++lane) all |= bits[lane];
  return static_cast<std::uint32_t>(all);
}

}  // namespace

template <int dim>
PoissonEquation<dim>::PoissonEquation(const PoissonParameters<dim>& parameters)
    : parameters_(parameters),
      reference_(reference_values<dim>(parameters.re, parameters.spacing)),
      open_surface_(OpenSurface::on_lattice<dim>(parameters.re, parameters.spacing, reference_.smooth0)) {}

template <int dim>
void PoissonEquation<dim>::number_unknowns(const Particles<dim>& particles, const CellGrid<dim>& grid) {
  place_.clear();
  other_.clear();
  rank_.clear();
  wet_ = {0};
  face_ = {0};
  cells_ = {};
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
    cells_.of_unknown.push_back(cells_.size() - 1);
    wet_.push_back(wet_.back() + (particles.kind[i] == Kind::body_surface ? 1 : 0));
    face_.push_back(face_.back() + (particles.kind[i] != Kind::fluid ? 1 : 0));
  }
  const auto size = static_cast<std::int32_t>(place_.size());
  rank_.push_back(size);
  cells_.first.push_back(size);
  cells_.of_unknown.push_back(cells_.size());
  x_ = in_lines([&](int i) { return particles.x[i]; });
}

/// The vector of value(place) over all unknowns.
template <int dim>
template <typename Value>
auto PoissonEquation<dim>::in_lines(Value&& value) const -> Lines {
  Lines lines;
  for (auto& line : lines) line.resize(place_.size() + Matrix::lanes);
  for (std::size_t m = 0; m < place_.size(); ++m) {
    const Vec<dim> v = value(place_[m]);
    for (int k = 0; k < dim; ++k) lines[k][m] = v[k];
  }
  return lines;
}

/// Weight of a neighbour that is not an unknown; 0 outside the radius.
template <int dim>
double PoissonEquation<dim>::weight_at(const Vec<dim>& x_ij) const {
  return weight_of(static_cast<float>(x_ij.squaredNorm()), static_cast<float>(parameters_.re));
}

/// Lists for each cell the lines of cells around it.
template <int dim>
void PoissonEquation<dim>::list_cells(const CellGrid<dim>& grid, int reach) {
  cells_.lines_per_cell = static_cast<int>(std::pow(2 * reach + 1, dim - 1));
  cells_.line.assign(cells_.cell.size() * static_cast<std::size_t>(cells_.lines_per_cell), {0, 0});
  for (int c = 0; c < cells_.size(); ++c) {
    auto* line = cells_.line.data() + static_cast<std::ptrdiff_t>(c) * cells_.lines_per_cell;
    CellIndex<dim> cell;
    for (int k = 0; k < dim; ++k) cell[k] = cells_.cell[c][k];
    grid.ranges(cell, reach, [&](std::int32_t first, std::int32_t last) {
      *line++ = {cells_.of_unknown[rank_[first]], cells_.of_unknown[rank_[last]]};
    });
  }
}

template <int dim>
void PoissonEquation<dim>::assemble(const Particles<dim>& particles, const CellGrid<dim>& grid,
                                    const std::vector<Vec<dim>>& areas, double tau) {
  number_unknowns(particles, grid);
  list_cells(grid, grid.reach(parameters_.re));
  const double scale = reference_.lambda0 * reference_.n0 / (2 * dim);
  const double stiffness = scale * parameters_.compressibility * parameters_.density / (tau * tau);
  const Assembly assembly{
      .particles = particles, .grid = grid, .areas = areas, .reach = grid.reach(parameters_.re)};
  A_.own.resize(place_.size());
  A_.diagonal.resize(place_.size());
  wall_.resize(place_.size());
  deviation_.resize(place_.size());
  sight_.resize(place_.size());
  const auto fill = [&](int k, std::int64_t begin) {
    Row row = fill_row(assembly, k, begin);
    double weights = 0;
    for (int lane = 0; lane < Matrix::lanes; ++lane) weights += row.weights[lane];
    double smooth = 1 + row.others;
    for (int lane = 0; lane < Matrix::lanes; ++lane) smooth += static_cast<double>(row.smooth[lane]);
    const double deviation = smooth / reference_.smooth0 - 1;
    if (parameters_.open_surface) open_to_air(-deviation, row);
    A_.own[k] = stiffness + row.diagonal;
    A_.diagonal[k] = A_.own[k] + weights;
    wall_[k] = row.wall;
    sight_[k] = row.sight;
    deviation_[k] = (row.sight & surface) != 0 ? std::nan("") : deviation;
    return row.end - begin;
  };
  const auto room = [&](std::int64_t blocks) { A_.make_room(blocks); };
  A_.rows.fill(static_cast<int>(place_.size()), expected_blocks(dim),
               most_entries(dim) / Matrix::lanes + cells_.lines_per_cell, room, fill);
}

template <int dim>
void PoissonEquation<dim>::set_source(const std::vector<double>& source) {
  b_ = rows_of(source);
  for (std::size_t k = 0; k < place_.size(); ++k) b_[k] += wall_[k];
}

template <int dim>
std::vector<double> PoissonEquation<dim>::divergence(const Particles<dim>& particles,
                                                     const CellGrid<dim>& grid, const Vec<dim>& kick) const {
  const Lines u = in_lines([&](int i) {
    return Vec<dim>(particles.kind[i] == Kind::fluid ? particles.u[i] : particles.u[i] + kick);
  });
  std::vector<double> divergence(place_.size(), std::nan(""));
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (std::size_t m = 0; m < place_.size(); ++m) {
    const auto k = static_cast<int>(m);
    const bool water = particles.kind[place_[m]] == Kind::fluid;
    if (!parameters_.open_surface && (!water || (sight_[m] & (bodies | surface)) != 0)) continue;
    if (!water || (sight_[m] & (walls | bodies)) != 0)
      divergence[m] = divergence_at_faces(particles, particles.u, grid, place_[m], kick);
    else
      divergence[m] = per_sum() * A_.template sum<Doubles>(k, [&](const Floats& weights, int column) {
        return parting(u, k, weights, column);
      });
  }
  return divergence;
}

template <int dim>
std::vector<double> PoissonEquation<dim>::divergence_by_bodies(const Particles<dim>& particles,
                                                               const std::vector<Vec<dim>>& velocity,
                                                               const CellGrid<dim>& grid) const {
  std::vector<double> divergence(place_.size(), 0.0);
#pragma omp parallel for schedule(dynamic, Rows::chunk)
  for (std::size_t m = 0; m < place_.size(); ++m) {
    if ((sight_[m] & bodies) == 0) continue;
    divergence[m] = parameters_.open_surface
                        ? divergence_at_faces(particles, velocity, grid, place_[m], Vec<dim>::Zero())
                        : std::nan("");
  }
  return divergence;
}

/// Converts a sum of eq. (10b) to the divergence.
template <int dim>
double PoissonEquation<dim>::per_sum() const {
  return dim / (reference_.lambda0 * reference_.n0);
}

template <int dim>
double PoissonEquation<dim>::divergence_at_faces(const Particles<dim>& particles,
                                                 const std::vector<Vec<dim>>& velocity,
                                                 const CellGrid<dim>& grid, int i,
                                                 const Vec<dim>& kick) const {
  const FaceRule<dim> rule{.re = parameters_.re,
                           .spacing = parameters_.spacing,
                           .face_factor = reference_.face_factor,
                           .kick = kick};
  return per_sum() * parting_at_faces(particles, velocity, grid, i, rule);
}

/// w_ij (u_j - u_i) . x_ij of unknown k and a block of others.
template <int dim>
Doubles PoissonEquation<dim>::parting(const Lines& velocity, int k, const Floats& weights, int column) const {
  Doubles sum{};
  for (int d = 0; d < dim; ++d) {
    const double* u = velocity[d].data();
    const double* x = x_[d].data();
    sum += (load<Doubles>(u + column) - u[k]) * (load<Doubles>(x + column) - x[k]);
  }
  return doubles_of(weights) * sum;
}

template <int dim>
std::vector<double> PoissonEquation<dim>::rows_of(const std::vector<double>& source) const {
  const double scale = reference_.lambda0 * reference_.n0 / (2 * dim);
  std::vector<double> rows(place_.size());
  for (std::size_t k = 0; k < place_.size(); ++k) rows[k] = -scale * source[place_[k]];
  return rows;
}

template <int dim>
auto PoissonEquation<dim>::fill_row(const Assembly& assembly, int k, std::int64_t begin) -> Row {
  Row row{.i = place_[k], .end = begin};
  assembly.grid.ranges(assembly.grid.cell_of(assembly.particles.x[row.i]), assembly.reach,
                       [&](std::int32_t first, std::int32_t last) {
                         fill_line(assembly, rank_[first], rank_[last], row);
                         add_others(assembly, first - rank_[first], last - rank_[last], row);
                       });
  return row;
}

/// Appends the weights between the particle of the row and the unknowns first ... last, in blocks that begin
/// with a nonzero weight.
template <int dim>
void PoissonEquation<dim>::fill_line(const Assembly& assembly, int first, int last, Row& row) {
  std::array<float, stretch + Matrix::lanes> weights;
  const Vec<dim>& x_i = assembly.particles.x[row.i];
  const bool beside_body = assembly.particles.kind[row.i] == Kind::body_surface || wet_[last] > wet_[first];
  for (int begin = first; begin < last; begin += stretch) {
    const int count = std::min(stretch, last - begin);
    weigh(x_i, begin, count, weights.data());
    for (int k = 0; face_[last] > face_[first] && k < count; ++k)
      if (weights[k] != 0 && face_[begin + k + 1] > face_[begin + k]) row.see(walls);
    if (beside_body) hide_behind_bodies(assembly, begin, count, weights.data(), row);
    append_blocks(begin, count, weights.data(), row);
  }
}

/// Weights of `count` columns from `first` on, padded with zeros to a block.
template <int dim>
void PoissonEquation<dim>::weigh(const Vec<dim>& x_i, int first, int count, float* weights) const {
  const auto re = static_cast<float>(parameters_.re);
  for (int block = 0; block < count; block += Matrix::lanes) {
#pragma omp simd simdlen(8)
    for (int lane = block; lane < block + Matrix::lanes; ++lane) {
      float r2 = 0;
      for (int k = 0; k < dim; ++k) {
        const auto d = static_cast<float>(x_[k][first + lane] - x_i[k]);
        r2 += d * d;
      }
      weights[lane] = weight_of(r2, re);
    }
  }
  std::fill(weights + count, weights + count + Matrix::lanes, 0.0F);
}

template <int dim>
void PoissonEquation<dim>::append_blocks(int first, int count, const float* weights, Row& row) {
  std::uint64_t left = 0;  // nonzero columns that no block contains yet
  for (int k = 0; k < count; k += Matrix::lanes) left |= std::uint64_t{not_zero(weights + k)} << k;
  while (left != 0) {
    const int from = std::countr_zero(left);
    const int column = Matrix::block_of(first + from, A_.size());
    auto block = load<Floats>(weights + from);
    if (const int shift = first + from - column; shift > 0) {
      std::array<float, 2 * Matrix::lanes> shifted{};
      std::copy_n(weights + from, Matrix::lanes - shift, shifted.begin() + shift);
      block = load<Floats>(shifted.data());
    }
    std::memcpy(A_.weight.data() + row.end * Matrix::lanes, &block, sizeof block);
    A_.first[row.end++] = column;
    row.weights += doubles_of(block);
    row.smooth += smooth_share(block);
    left &= ~(std::uint64_t{(1U << Matrix::lanes) - 1} << from);
  }
}

/// Removes pairs on opposite sides of a body; each particle sees a wall there (eq. 11).
template <int dim>
void PoissonEquation<dim>::hide_behind_bodies(const Assembly& assembly, int first, int count, float* weights,
                                              Row& row) const {
  const Particles<dim>& particles = assembly.particles;
  const bool on_body = particles.kind[row.i] == Kind::body_surface;
  for (int k = 0; k < count; ++k) {
    if (weights[k] == 0) continue;
    const int j = place_[first + k];
    if (particles.kind[j] == Kind::body_surface) row.see(bodies);
    const Vec<dim> x_ij = particles.x[j] - particles.x[row.i];
    const double r = x_ij.norm();
    const bool hidden =
        (on_body && behind_face<dim>(assembly.areas[row.i], x_ij, r)) ||
        (particles.kind[j] == Kind::body_surface && behind_face<dim>(assembly.areas[j], -x_ij, r));
    if (!hidden) continue;
    row.wall += static_cast<double>(weights[k]) * parameters_.density * parameters_.gravity.dot(x_ij);
    row.others += smooth_share(static_cast<double>(weights[k]));
    weights[k] = 0;
  }
}

/// Adds a weight towards P = 0 for the missing neighbours of the particle.
template <int dim>
void PoissonEquation<dim>::open_to_air(double lack, Row& row) const {
  const double weight = open_surface_.weight(lack);
  if (weight == 0) return;
  row.diagonal += weight;
  row.see(surface);
}

/// Adds the terms of the particles first ... last without an unknown: P = 0 of the free surface, and the
/// Neumann condition of walls.
template <int dim>
void PoissonEquation<dim>::add_others(const Assembly& assembly, int first, int last, Row& row) const {
  const Particles<dim>& particles = assembly.particles;
  const bool on_body = particles.kind[row.i] == Kind::body_surface;
  for (int m = first; m < last; ++m) {
    const int j = other_[m];
    const Vec<dim> x_ij = particles.x[j] - particles.x[row.i];
    const double w = weight_at(x_ij);
    if (w == 0) continue;
    const double r = x_ij.norm();
    const bool dry = parameters_.open_surface && particles.kind[j] != Kind::fluid;
    const bool wall =
        dry || !has_pressure(particles.kind[j]) ||
        (on_body && behind_face<dim>(assembly.areas[row.i], x_ij, r)) ||
        (particles.kind[j] == Kind::body_surface && behind_face<dim>(assembly.areas[j], -x_ij, r));
    if (wall) {
      row.wall += w * parameters_.density * parameters_.gravity.dot(x_ij);
      row.others += smooth_share(w);
      row.see(of_body(particles.kind[j]) ? bodies : walls);
    } else {
      row.diagonal += w;
      row.others += smooth_share(w);
      if (!parameters_.open_surface) row.see(surface);
    }
  }
}

template class PoissonEquation<2>;
template class PoissonEquation<3>;

}  // namespace cosurge::fluid
