// Points that are spread evenly at one depth below an outline.
#pragma once

#include "fluid_solver/outline_depth.hpp"
#include "fluid_solver/point_hash.hpp"

namespace cosurge::fluid {

/// One layer of wall particles.
template <int dim>
class EvenLayer {
 public:
  /// `fixed` are points that the layer keeps away from and does not move.
  EvenLayer(const OutlineDepth<dim>& outline, const PointHash<dim>& fixed, double depth, double spacing);

  /// How far points of a layer look for others, in spacings.
  static constexpr double reach = 1.5;

  /// Adds the points of a grid, except where others are near.
  void add_grid(const std::vector<Vec<dim>>& grid);

  /// Fills the rest of the layer from `candidates`, which lie densely at its depth: repeatedly adds the
  /// candidate that is nearest to two points of the layer and not closer to any point than the spacing allows
  /// (docs/method.md, Walls).
  void fill(const std::vector<Vec<dim>>& candidates);

  /// Whether a new point at x would lie too near to others.
  bool occupied(const Vec<dim>& x, double margin) const;

  /// Lets points off the regular grids, and grid points beside them, repel each other along the layer, in at
  /// most `sweeps` sweeps.
  void spread(int sweeps);

  const std::vector<Vec<dim>>& points() const { return points_; }

 private:
  std::vector<std::int32_t> movable() const;
  Vec<dim> push_on(const PointHash<dim>& all, std::int32_t i) const;

  const OutlineDepth<dim>& outline_;
  const PointHash<dim>& fixed_;
  double depth_, spacing_;
  std::vector<Vec<dim>> points_;
  PointHash<dim> hash_;
  std::size_t regular_ = 0;  // number of grid points; they come first in points_
};

}  // namespace cosurge::fluid
