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

  /// The nearest point at this depth on the straight line from x to the outline. If another facet comes
  /// nearer on the way, the search continues from there, for a few steps. Nothing if the body is too thin for
  /// such a point.
  std::optional<Vec<dim>> at_depth(const Vec<dim>& x, double depth) const;

  /// Whether the depth of x equals `depth` [m] up to 2e-3 spacings.
  bool is_at_depth(const Vec<dim>& x, double depth) const;

  /// Wetted facets that do not lie on faces of lattice cells.
  const std::vector<Facet<dim>>& oblique() const { return oblique_; }

  /// Whether all wetted facets whose distance from x exceeds the least one by at most `margin` lie on faces
  /// of lattice cells.
  bool on_lattice(const Vec<dim>& x, double margin) const;

 private:
  const Shape<dim>& shape_;
  double spacing_;
  FacetTree<dim> wetted_;
  std::vector<Facet<dim>> oblique_;
  FacetTree<dim> oblique_tree_;
};

}  // namespace cosurge::fluid
