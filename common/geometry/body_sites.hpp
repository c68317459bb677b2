// The sites of the lattice that a body takes.
#pragma once

#include "common/cell_block.hpp"
#include "common/geometry/shape.hpp"

namespace cosurge {

/// Sites inside the body's shape; of an outline those that belong to blocks of 2^dim such sites, so that
/// every site has neighbours in all directions, at a sharp tip too. Water, particles and frames have the same
/// sites of a body where they have the same spacing.
template <int dim>
class BodySites {
 public:
  BodySites(const Shape<dim>& shape, double spacing);

  /// The first coordinate fastest.
  const std::vector<Vec<dim>>& all() const { return sites_; }

  /// Whether x lies in the cell of one.
  bool contains(const Vec<dim>& x) const;

  /// Number of parts that do not touch by faces of their cells.
  int parts() const { return block_.parts(taken_); }

 private:
  using Index = typename CellBlock<dim>::Index;

  std::vector<char> blocks(const std::vector<char>& inside) const;

  double spacing_;
  Index lower_;  // first cell of the block around the body
  CellBlock<dim> block_;
  std::vector<char> taken_;  // whether the body takes each cell of the block
  std::vector<Vec<dim>> sites_;
};

}  // namespace cosurge
