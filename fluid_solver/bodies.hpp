// The structures as the water sees them: points on the lattice, with area vectors on the wet surface.
#pragma once

#include <vector>

#include "common/body_sites.hpp"
#include "common/participant.hpp"

namespace cosurge::fluid {

/// Reference points of all bodies and their neighbours within each body, for the deformation of the surface.
template <int dim>
class Bodies {
 public:
  Bodies() = default;

  /// Points on the sites of the bodies. Area vectors count the missing lattice faces, A_0 = l0^(d-1) sum of
  /// face normals, eq. (14); faces towards a clamp or out of `tank` are not wet. So the areas of a body that
  /// is wet all around add up to zero and uniform pressure gives no net force.
  Bodies(const v1::Solid& solid, const Box<dim>& tank, double spacing);

  int points() const { return static_cast<int>(position_.size()); }
  const Vec<dim>& position(int k) const { return position_[static_cast<std::size_t>(k)]; }
  bool wet(int k) const { return !area_[static_cast<std::size_t>(k)].isZero(); }

  /// Area vectors of the deformed surface by Nanson's formula, eq. (13): A = J F^-T A_0, with F fitted to the
  /// displacement of the reference neighbours, eq. (12). `displacement` is dimension x points [m].
  std::vector<Vec<dim>> deformed_areas(const Field& displacement) const;

  Interface interface() const;

 private:
  void find_neighbors(double spacing);

  std::vector<Vec<dim>> position_;
  std::vector<Vec<dim>> area_;  // A_0
  std::vector<int> body_;
  std::vector<int> neighbor_begin_;  // of each point, and the end
  std::vector<int> neighbor_;
};

}  // namespace cosurge::fluid
