// How deep a point lies below the wetted outline of an obstacle.
#pragma once

#include <optional>

#include "common/geometry/shape.hpp"

namespace cosurge::fluid {

/// A point's depth below the facets that water can reach.
template <int dim>
struct Depth {
  double depth;      // positive inside [m]
  Vec<dim> nearest;  // point of the outline
};

/// Signed distance from the wetted facets of a closed outline. Where `tank` is given, the facets that lie in
/// its floor and side walls are left out: no water wets them.
template <int dim>
class OutlineDepth {
 public:
  OutlineDepth(const Shape<dim>& shape, const std::optional<Box<dim>>& tank, double spacing);

  Depth<dim> at(const Vec<dim>& x) const;

  /// The nearest point at this depth that lies on the straight line from x to the outline; x moves on by a
  /// few such steps where another facet comes nearer. None where there is no such point: the body is too
  /// thin.
  std::optional<Vec<dim>> at_depth(const Vec<dim>& x, double depth) const;

  /// Whether the depth of x is `depth`, to a share of a spacing that no flow resolves.
  bool is_at_depth(const Vec<dim>& x, double depth) const;

  /// Wetted facets that do not lie on faces of lattice cells.
  const std::vector<Facet<dim>>& oblique() const { return oblique_; }

  /// Whether all wetted facets as near to x as the nearest one and `margin` more lie on faces of lattice
  /// cells.
  bool on_lattice(const Vec<dim>& x, double margin) const;

 private:
  const Shape<dim>& shape_;
  double spacing_;
  FacetTree<dim> wetted_;
  std::vector<Facet<dim>> oblique_;
  FacetTree<dim> oblique_tree_;
};

}  // namespace cosurge::fluid
