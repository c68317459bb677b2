#include "fluid_solver/cell_grid.hpp"

#include <numeric>

namespace cosurge::fluid {

template <int dim>
CellGrid<dim>::CellGrid(const Box<dim>& domain, double cell_size) : origin_(domain.min), size_(cell_size) {
  count_ = ((domain.max - domain.min) / cell_size).array().ceil().template cast<int>();
  start_.assign(static_cast<std::size_t>(count_.prod()) + 1, 0);
}

template <int dim>
std::vector<std::int32_t> CellGrid<dim>::sort(const std::vector<Vec<dim>>& x) {
  const auto points = static_cast<std::int32_t>(x.size());
  cell_.resize(x.size());
  std::fill(start_.begin(), start_.end(), 0);
  for (std::int32_t i = 0; i < points; ++i) {
    const CellIndex<dim> cell = cell_of(x[i]);
    const bool inside = (cell.array() >= 0).all() && (cell.array() < count_.array()).all();
    cell_[i] = inside ? number(cell) : -1;
    if (inside) ++start_[cell_[i] + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<std::int32_t> order(static_cast<std::size_t>(start_.back()));
  std::vector<std::int32_t> next(start_.begin(), start_.end() - 1);
  for (std::int32_t i = 0; i < points; ++i)
    if (cell_[i] >= 0) order[next[cell_[i]]++] = i;
  return order;
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace cosurge::fluid
