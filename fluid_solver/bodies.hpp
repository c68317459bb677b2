// The structures as the water sees them: points on the lattice, with area vectors on the wet surface.
#pragma once

#include <vector>

#include "common/body_sites.hpp"
#include "common/participant.hpp"

namespace cosurge::fluid {

/// The deformed surface, by point of the bodies.
template <int dim>
struct Faces {
  /// Area vectors by Nanson's formula, eq. (13): A = J F^-T A_0, with F fitted to the displacement of the
  /// reference neighbours, eq. (12). Zero inside.
  std::vector<Vec<dim>> area;
  /// Sum of a (x) a / |a| over the area vectors a of the point's wet lattice faces, deformed the same way:
  /// times a pressure gradient and half a spacing, what the load on the faces has beyond that of the pressure
  /// in the centre.
  std::vector<Mat<dim>> spread;
  /// Unit normals, towards the water; of inner points that of the nearest wet point.
  std::vector<Vec<dim>> normal;
};

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

  /// The point whose velocity the water sees in point k: the nearest wet one. So a body that is compressed
  /// inside compresses no water.
  int face_point(int k) const {
    const int nearest = nearest_wet_[static_cast<std::size_t>(k)];
    return nearest >= 0 ? nearest : k;
  }

  /// The surface that `displacement` (dimension x points [m]) has deformed.
  Faces<dim> deformed(const Field& displacement) const;

  Interface interface() const;

 private:
  void find_neighbors(double spacing);
  void find_nearest_wet();
  Mat<dim> cofactor(int k, const Field& displacement) const;

  std::vector<Vec<dim>> position_;
  std::vector<Vec<dim>> area_;   // A_0
  std::vector<Vec<dim>> faces_;  // area of the wet lattice faces across each axis, without sign
  std::vector<int> nearest_wet_;
  std::vector<int> body_;
  std::vector<int> neighbor_begin_;  // of each point, and the end
  std::vector<int> neighbor_;
};

}  // namespace cosurge::fluid
