// Which elements may hold a point.
#pragma once

#include <vector>

#include "common/cell_block.hpp"
#include "common/geometry/lattice.hpp"

namespace cosurge::fem {

/// An even grid of bins over the boxes of elements; each bin lists, in ascending order, the elements whose
/// boxes reach into it.
template <int dim>
class ElementBins {
 public:
  ElementBins() = default;

  /// @param boxes one for each element
  explicit ElementBins(const std::vector<Box<dim>>& boxes);

  /// The elements of the bin of x; none outside all boxes.
  const std::vector<Eigen::Index>& at(const Vec<dim>& x) const;

 private:
  using Index = typename CellBlock<dim>::Index;

  Index bin_of(const Vec<dim>& x) const;

  Vec<dim> origin_ = Vec<dim>::Zero(), side_ = Vec<dim>::Ones();
  CellBlock<dim> block_;
  std::vector<std::vector<Eigen::Index>> elements_;
  std::vector<Eigen::Index> none_;
};

}  // namespace cosurge::fem
