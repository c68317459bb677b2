// The structures as the water sees them: points on the lattice, with area vectors on the wet surface.
#pragma once

#include <vector>

#include "common/geometry/body_sites.hpp"
#include "common/participant.hpp"
#include "fluid_solver/water.hpp"

namespace cosurge::fluid {

/// Areas or shares of the faces of a site's cell, towards either side of each axis.
template <int dim>
struct LatticeFaces {
  Vec<dim> below, above;
};

/// Share of each face of a site's cell that water can reach.
template <int dim>
struct Openness : LatticeFaces<dim> {
  Openness() : LatticeFaces<dim>{.below = Vec<dim>::Ones(), .above = Vec<dim>::Ones()} {}
};

/// The deformed surface, by point of the bodies.
template <int dim>
struct Faces {
  /// Area vectors by Nanson's formula, eq. (13): A = J F^-T A_0, with F fitted to the displacement of the
  /// reference neighbours, eq. (12). Zero inside.
  std::vector<Vec<dim>> area;
  /// Sum of a (x) a / |a| over the area vectors a of the point's wet lattice faces, deformed the same way:
  /// multiplied by a pressure gradient and half a spacing, this is the load on the faces minus the load of
  /// the pressure at the centre.
  std::vector<Mat<dim>> spread;
  /// Unit normals, towards the water; inner points have the normal of the nearest wet point.
  std::vector<Vec<dim>> normal;
  std::vector<Mat<dim>> cofactor;  ///< J F^-T of wet points
  std::vector<char> open;          ///< whether water can reach the point
};

/// Reference points of all bodies and their neighbours within each body, for the deformation of the surface.
template <int dim>
class Bodies {
 public:
  Bodies() = default;

  /// Points on the sites of the bodies. Area vectors count the missing lattice faces, A_0 = l0^(d-1) sum of
  /// face normals, eq. (14); faces towards a clamp or out of `tank` are not wet. So the areas of a body that
  /// is wet all around add up to zero and uniform pressure gives no net force. Faces towards obstacles and
  /// other bodies are wet as soon as there is a gap (CoveredFaces).
  Bodies(const std::vector<WetBody<dim>>& bodies, const Box<dim>& tank, double spacing);

  std::size_t count() const { return held_at_rest_.size(); }
  /// Whether something that does not move in the tank holds the body.
  bool held_at_rest(std::size_t body) const { return held_at_rest_[body]; }

  int points() const { return static_cast<int>(position_.size()); }
  const Vec<dim>& position(int k) const { return position_[static_cast<std::size_t>(k)]; }
  int body(int k) const { return body_[static_cast<std::size_t>(k)]; }
  /// Whether the point has a face that neither its body, nor clamps, nor the tank cover at the start.
  bool wet(int k) const { return !area_[static_cast<std::size_t>(k)].isZero(); }

  /// The point whose velocity the water sees in point k: the nearest wet one. So a body that is compressed
  /// inside compresses no water.
  int face_point(int k) const {
    const int nearest = nearest_wet_[static_cast<std::size_t>(k)];
    return nearest >= 0 ? nearest : k;
  }

  /// Areas of its wet lattice faces at the start.
  const LatticeFaces<dim>& lattice_faces(int k) const { return faces_[static_cast<std::size_t>(k)]; }

  /// The surface that `displacement` (dimension x points [m]) has deformed; all of it is open to the water.
  Faces<dim> deformed(const Field& displacement) const;

  /// Reduces the areas to the part that is open to the water.
  void set_open(const std::vector<Openness<dim>>& open, Faces<dim>& faces) const;

  Interface interface() const;

 private:
  void find_neighbors(double spacing);
  void find_nearest_wet(double spacing);
  Mat<dim> cofactor(int k, const Field& displacement) const;

  std::vector<bool> held_at_rest_;
  std::vector<Vec<dim>> position_;
  std::vector<Vec<dim>> area_;            // A_0
  std::vector<Vec<dim>> normal_;          // normals of the undeformed faces
  std::vector<LatticeFaces<dim>> faces_;  // areas of the wet lattice faces
  std::vector<int> nearest_wet_;
  std::vector<int> body_;
  std::vector<int> neighbor_begin_;  // first neighbour of each point, and the end
  std::vector<int> neighbor_;
};

}  // namespace cosurge::fluid
