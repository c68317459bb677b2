// Regions of a case, and the sites of the lattice within them.
#pragma once

#include "common/geometry/facet_tree.hpp"
#include "common/geometry/lattice.hpp"

namespace cosurge {

/// A box, or the inside of a closed outline: a polygon in two dimensions, triangles in three.
template <int dim>
class Shape {
 public:
  /// A side of a polygon, or a triangle.
  using Facet = cosurge::Facet<dim>;

  explicit Shape(const Box<dim>& box) : bounds_(box) {}

  /// @param corners of a polygon, one after the other, or three of each triangle [m]
  explicit Shape(const std::vector<Vec<dim>>& corners);

  /// The same shape elsewhere.
  Shape moved(const Vec<dim>& by) const;

  /// Whether x is inside: on a box's boundary is, on an outline's may be. Inside of an outline is where its
  /// winding number is not zero, so that closed parts of one orientation that overlap are one body.
  bool contains(const Vec<dim>& x) const;

  /// How many times the outline goes around x: a ray along the first coordinate crosses it as many times more
  /// outwards than inwards (Hormann & Agathos 2001, Comput. Geom. 20, 131). Negative for an outline that is
  /// inside out. Of triangles that are not ordered alike it is 1 where the ray crosses an odd number of them
  /// (Shimrat 1962, CACM 5, 434), else 0.
  int winding(const Vec<dim>& x) const;

  bool is_box() const { return facets_.empty(); }
  const Box<dim>& bounds() const { return bounds_; }
  const std::vector<Facet>& facets() const { return facets_; }  ///< facets of an outline; empty for a box

  /// The point of the boundary that is nearest to x.
  Vec<dim> nearest(const Vec<dim>& x) const;

  /// How far x lies outside, along the axis where it is farthest [m]; 0 inside.
  double outside(const Vec<dim>& x) const;

  /// Share of the way from x, outside, to x + way, inside, before it enters.
  double share_outside(const Vec<dim>& x, const Vec<dim>& way) const;

  /// Sites of the lattice that lie inside, the first coordinate fastest.
  std::vector<Vec<dim>> fill(double spacing) const;

 private:
  void index_facets();

  Box<dim> bounds_;
  std::vector<Facet> facets_;
  FacetTree<dim> tree_;
  bool oriented_ = true;  // whether all facets have their inner side on the same hand
};

/// Normal of a facet, as long as it is large (in space: twice its area).
Vec<2> normal_of(const Shape<2>::Facet& side);
Vec<3> normal_of(const Shape<3>::Facet& triangle);

}  // namespace cosurge
