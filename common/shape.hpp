// Regions of a case, and the sites of the lattice within them.
#pragma once

#include "common/lattice.hpp"

namespace cosurge {

/// A box, or what a closed outline encloses: a polygon in two dimensions, triangles in three.
template <int dim>
class Shape {
 public:
  explicit Shape(const v1::Shape& shape);

  /// Whether x is inside: on a box's boundary is, on an outline's may be. An outline is crossed by a ray
  /// along the first coordinate an odd number of times from inside (Shimrat 1962, CACM 5, 434).
  bool contains(const Vec<dim>& x) const;

  const Box<dim>& bounds() const { return bounds_; }

  /// Sites of the lattice that lie inside, the first coordinate fastest.
  std::vector<Vec<dim>> fill(double spacing) const;

 private:
  Box<dim> bounds_;
  std::vector<Vec<dim>> vertex_;  // of an outline; none for a box
};

}  // namespace cosurge
