// Neighbour lists of the small radius, on which all operators but the Laplacian of the pressure work.
#pragma once

#include "fluid_solver/cell_grid.hpp"
#include "fluid_solver/particles.hpp"
#include "fluid_solver/rows.hpp"
#include "fluid_solver/unfilled.hpp"
#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {

/// For each particle with a pressure, the particles within r_e in ascending place, itself left out. Cells are
/// r_e wide and shared with the pressure equation.
template <int dim>
class Neighbors {
 public:
  /// `re` in metres; particles outside `domain` are dropped when the particles are sorted.
  Neighbors(const Box<dim>& domain, double re) : re_(re), grid_(domain, re) {}

  /// Sorts the particles by cell and lists neighbours.
  /// @throws NumericalError when so many particles share a cell that the water cannot be incompressible.
  void rebuild(Particles<dim>& particles);

  const CellGrid<dim>& grid() const { return grid_; }
  double re() const { return re_; }

  /// Calls visit(j, x_j - x_i, r) for each neighbour j of particle i with r_ij < r_e, in ascending order.
  template <typename Visit>
  void each(const Particles<dim>& particles, int i, Visit&& visit) const {
    for (std::int64_t k = rows_.begin(i); k < rows_.end(i); ++k) {
      const std::int32_t j = index_[static_cast<std::size_t>(k)];
      const Vec<dim> x_ij = particles.x[j] - particles.x[i];
      visit(j, x_ij, x_ij.norm());
    }
  }

  /// The same with the weight: visit(j, x_ij, r, w). Particles must be where they were in rebuild(). In two
  /// dimensions r and w are listed: there are few, and seven sums a step use them.
  template <typename Visit>
  void each_weighted(const Particles<dim>& particles, int i, Visit&& visit) const {
    if constexpr (dim == 2) {
      for (std::int64_t k = rows_.begin(i); k < rows_.end(i); ++k) {
        const auto at = static_cast<std::size_t>(k);
        const std::int32_t j = index_[at];
        visit(j, Vec<dim>(particles.x[j] - particles.x[i]), distance_[at], weight_[at]);
      }
    } else {
      each(particles, i, [&](int j, const Vec<dim>& x_ij, double r) { visit(j, x_ij, r, weight(r, re_)); });
    }
  }

  int count(int i) const { return static_cast<int>(rows_.end(i) - rows_.begin(i)); }

 private:
  double re_;
  CellGrid<dim> grid_;
  Rows rows_;
  Unfilled<std::int32_t> index_;
  Unfilled<double> distance_, weight_;  // r and w of every pair, in two dimensions only
};

}  // namespace cosurge::fluid
