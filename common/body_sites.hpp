// The sites of the lattice that a body takes.
#pragma once

#include "common/shape.hpp"

namespace cosurge {

/// Sites inside the body's shape; of an outline those that belong to blocks of 2^dim such sites, so that
/// every site has neighbours in all directions, at a sharp tip too. Water, particles and frames have the same
/// sites of a body where they have the same spacing.
template <int dim>
class BodySites {
 public:
  BodySites(const v1::Body& body, double spacing);

  /// The first coordinate fastest.
  const std::vector<Vec<dim>>& all() const { return sites_; }

  /// Whether x lies in the cell of one.
  bool contains(const Vec<dim>& x) const;

  /// Number of parts that do not touch by faces of their cells.
  int parts() const;

 private:
  using Index = Eigen::Matrix<long, dim, 1>;

  long cell(const Index& k) const;  // -1 outside the block of cells
  Index place(long cell) const;
  std::vector<char> blocks(const std::vector<char>& inside) const;

  double spacing_;
  Index lower_, count_;      // of the cells around the body
  std::vector<char> taken_;  // of these
  std::vector<Vec<dim>> sites_;
};

}  // namespace cosurge
