// Cells of the neighbour search.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/geometry/lattice.hpp"

namespace cosurge::fluid {

template <int dim>
using CellIndex = Eigen::Matrix<int, dim, 1>;

/// Square cells over a fixed domain, numbered with the first coordinate fastest. Particles are kept in the
/// order of their cells, so that a run of cells along the first coordinate is one contiguous range of
/// particles.
template <int dim>
class CellGrid {
 public:
  CellGrid(const Box<dim>& domain, double cell_size);

  /// Order of the points by cell, stable within a cell; points outside the domain are left out. Afterwards
  /// ranges refer to places in this order.
  std::vector<std::int32_t> sort(const std::vector<Vec<dim>>& x);

  CellIndex<dim> cell_of(const Vec<dim>& x) const {
    return ((x - origin_) / size_).array().floor().template cast<int>();
  }

  int number(const CellIndex<dim>& cell) const {
    int index = cell[dim - 1];
    for (int k = dim - 2; k >= 0; --k) index = index * count_[k] + cell[k];
    return index;
  }

  std::int32_t first(int cell) const { return start_[static_cast<std::size_t>(cell)]; }
  int population(int cell) const { return start_[static_cast<std::size_t>(cell) + 1] - first(cell); }
  int cells() const { return static_cast<int>(start_.size()) - 1; }
  const CellIndex<dim>& counts() const { return count_; }
  double cell_size() const { return size_; }

  /// Number of cells on each side of a cell that a radius [m] reaches into.
  int reach(double radius) const { return static_cast<int>(std::ceil(radius * (1 - 1e-9) / size_)); }

  /// Calls visit(first, last) for each contiguous range of places in the cells within `reach` cells around
  /// `cell`.
  template <typename Visit>
  void ranges(const CellIndex<dim>& cell, int reach, Visit&& visit) const {
    CellIndex<dim> lower = (cell.array() - reach).max(0);
    const CellIndex<dim> upper = (cell.array() + reach).min(count_.array() - 1);
    const auto run = static_cast<std::size_t>(upper[0] - lower[0]) + 1;
    CellIndex<dim> at = lower;
    while (true) {
      const auto first = static_cast<std::size_t>(number(at));
      visit(start_[first], start_[first + run]);
      int axis = 1;
      while (axis < dim && ++at[axis] > upper[axis]) {
        at[axis] = lower[axis];
        ++axis;
      }
      if (axis == dim) return;
    }
  }

 private:
  Vec<dim> origin_;
  double size_;
  CellIndex<dim> count_;
  std::vector<std::int32_t> start_;  // first place of each cell, and the end
  std::vector<std::int32_t> cell_;
};

}  // namespace cosurge::fluid
