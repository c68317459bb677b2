#include "fluid_solver/pressure/poisson_equation.hpp"

#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

constexpr int expected_neighbors(int dim) { return dim == 2 ? 52 : 290; }  // 44 and 250 on the lattice, and disorder
constexpr double facing_away = -0.5;  // cosine between a wet face and the way to a neighbour behind the body

template <int dim>
bool behind(const Vec<dim>& area, const Vec<dim>& way, double r) {
  return area.dot(way) < facing_away * area.norm() * r;
}

}  // namespace

template <int dim>
PoissonEquation<dim>::PoissonEquation(const PoissonParameters<dim>& parameters)
    : parameters_(parameters), reference_(reference_values<dim>(parameters.re, parameters.spacing)) {}

template <int dim>
void PoissonEquation<dim>::number_unknowns(const Particles<dim>& particles, const CellGrid<dim>& grid) {
  place_.clear();
  unknown_.assign(static_cast<std::size_t>(particles.size()), -1);
  cells_.first.clear();
  cells_.cell.clear();
  CellIndex<dim> last = CellIndex<dim>::Constant(-1);
  for (int i = 0; i < particles.size(); ++i) {
    if (!has_pressure(particles.kind[i]) || particles.free_surface[i] != 0) continue;
    const CellIndex<dim> cell = grid.cell_of(particles.x[i]);
    const auto number = static_cast<std::int32_t>(place_.size());
    if (cell != last) {
      last = cell;
      cells_.first.push_back(number);
      cells_.cell.push_back({cell[0], cell[1], dim == 3 ? cell[dim - 1] : 0});
    }
    unknown_[i] = number;
    place_.push_back(i);
  }
  cells_.first.push_back(static_cast<std::int32_t>(place_.size()));
}

template <int dim>
void PoissonEquation<dim>::assemble(const Particles<dim>& particles, const CellGrid<dim>& grid,
                                    const std::vector<double>& source, const std::vector<Vec<dim>>& areas, double dt) {
  number_unknowns(particles, grid);
  const double scale = reference_.lambda0 * reference_.n0 / (2 * dim);
  const double stiffness = scale * parameters_.compressibility * parameters_.density / (dt * dt);
  const double re = parameters_.re;
  const double re2 = re * re * (1 - 1e-9);  // sites on the edge do not count, as in the reference values
  const Vec<dim> rho_g = parameters_.density * parameters_.gravity;
  const int reach = static_cast<int>(std::ceil(std::sqrt(re2) / grid.cell_size()));
  const auto* x = particles.x.data();
  A_.diagonal.resize(place_.size());
  b_.resize(place_.size());

  const auto row = [&](int k, std::int64_t begin) {
    const int i = place_[k];
    const bool on_body = particles.kind[i] == Kind::body_surface;
    std::int32_t* const near = A_.column.data() + begin;
    std::int64_t candidates = 0;
    grid.ranges(grid.cell_of(x[i]), reach, [&](std::int32_t first, std::int32_t last) {
      for (std::int32_t j = first; j < last; ++j) {
        near[candidates] = j;
        candidates += static_cast<std::int64_t>((x[j] - x[i]).squaredNorm() < re2) & static_cast<std::int64_t>(j != i);
      }
    });
    double diagonal = stiffness;
    double wall = 0;
    std::int64_t count = 0;
    for (std::int64_t c = 0; c < candidates; ++c) {
      const std::int32_t j = near[c];
      const Vec<dim> x_ij = x[j] - x[i];
      const double r = x_ij.norm();
      const auto w = static_cast<float>(weight(r, re));
      if (!has_pressure(particles.kind[j]) || (on_body && behind<dim>(areas[i], x_ij, r)) ||
          (particles.kind[j] == Kind::body_surface && behind<dim>(areas[j], -x_ij, r))) {
        wall += static_cast<double>(w) * rho_g.dot(x_ij);
        continue;
      }
      diagonal += w;
      if (unknown_[j] < 0) continue;
      A_.column[begin + count] = unknown_[j];
      A_.weight[begin + count] = w;
      ++count;
    }
    A_.diagonal[k] = diagonal;
    b_[k] = -scale * source[i] + wall;
    return count;
  };
  const auto room = [&](std::int64_t entries) {
    A_.column.resize(static_cast<std::size_t>(entries));
    A_.weight.resize(static_cast<std::size_t>(entries));
  };
  A_.rows.fill(static_cast<int>(place_.size()), expected_neighbors(dim), most_entries(dim), room, row);
}

template class PoissonEquation<2>;
template class PoissonEquation<3>;

}  // namespace cosurge::fluid
