// Boxes, and the lattice that fills them with particles.
#pragma once

#include <cmath>
#include <vector>

#include "common/vec.hpp"

namespace cosurge {

/// Closed box between two corners [m].
template <int dim>
struct Box {
  Vec<dim> min;
  Vec<dim> max;

  Box(const Vec<dim>& lower, const Vec<dim>& upper) : min(lower), max(upper) {}

  bool contains(const Vec<dim>& x) const {
    return (x.array() >= min.array()).all() && (x.array() <= max.array()).all();
  }
};

/// Centre (k + 1/2) l0 of a site of the one lattice that all particles of a spacing share. Both solvers get
/// the same bits for the same site.
template <int dim>
Vec<dim> site(const Eigen::Matrix<long, dim, 1>& k, double spacing) {
  return (k.template cast<double>().array() + 0.5) * spacing;
}

/// Sites whose cells fill `box`, the first coordinate fastest. Sides must be whole multiples of the spacing
/// (refused otherwise when the case is read).
template <int dim>
std::vector<Vec<dim>> fill(const Box<dim>& box, double spacing) {
  using Index = Eigen::Matrix<long, dim, 1>;
  const Index lower = (box.min / spacing).array().round().template cast<long>();
  const Index upper = (box.max / spacing).array().round().template cast<long>();
  std::vector<Vec<dim>> sites;
  if ((upper.array() <= lower.array()).any()) return sites;
  Index k = lower;
  while (true) {
    sites.push_back(site<dim>(k, spacing));
    int axis = 0;
    while (axis < dim && ++k[axis] == upper[axis]) {
      k[axis] = lower[axis];
      ++axis;
    }
    if (axis == dim) return sites;
  }
}

}  // namespace cosurge
