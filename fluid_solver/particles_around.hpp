// The particles around any point.
#pragma once

#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

/// Calls visit(j, x_j - x, |x_j - x|) for the particles within r_e of a point in the domain.
template <int dim, typename Visit>
void each_around(const Mps<dim>& mps, const Vec<dim>& x, Visit&& visit) {
  const CellGrid<dim>& grid = mps.neighbors().grid();
  const CellIndex<dim> cell = grid.cell_of(x);
  if ((cell.array() < 0).any() || (cell.array() >= grid.counts().array()).any()) return;
  grid.ranges(cell, 1, [&](std::int32_t first, std::int32_t last) {
    for (std::int32_t j = first; j < last; ++j) {
      const Vec<dim> way = mps.particles().x[j] - x;
      if (const double r = way.norm(); r < mps.neighbors().re()) visit(j, way, r);
    }
  });
}

}  // namespace cosurge::fluid
