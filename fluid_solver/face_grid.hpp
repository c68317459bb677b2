// Regular grids on the plane faces of an outline.
#pragma once

#include "fluid_solver/outline_depth.hpp"

namespace cosurge::fluid {

/// A plane face of an outline: all facets in one plane, in axes of its own.
template <int dim>
class FaceGrid {
 public:
  /// Groups facets that lie in one plane, the largest first; leaves out planes whose extent is less than
  /// three spacings along an axis.
  static std::vector<FaceGrid> faces(const std::vector<Facet<dim>>& facets, double spacing);

  /// Points at this depth below the face, on a grid whose outermost rows lie at its ends and whose pitch is
  /// the spacing, stretched to a whole number of pitches.
  std::vector<Vec<dim>> points(const OutlineDepth<dim>& outline, double depth, double spacing) const;

 private:
  static constexpr int flat = dim - 1;
  using Plane = Eigen::Matrix<double, flat, 1>;
  using Axes = Eigen::Matrix<double, dim, flat>;
  struct Extent {
    Plane low, high;
  };

  FaceGrid(const std::vector<Facet<dim>>& facets, const Vec<dim>& normal);

  static Extent extent_of(const std::vector<Facet<dim>>& facets, const Axes& axes, const Vec<dim>& origin);
  Vec<dim> at(const Plane& in_plane, double depth) const;
  std::optional<Extent> extent_at(const OutlineDepth<dim>& outline, double depth, double spacing) const;

  Vec<dim> origin_, normal_;
  Axes axes_;
  Extent extent_;
};

}  // namespace cosurge::fluid
