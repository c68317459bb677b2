// The surface of a shape as facets no longer than a spacing.
#pragma once

#include <array>
#include <vector>

#include "common/geometry/shape.hpp"
#include "common/participant.hpp"

namespace cosurge::contact {

/// Vertices and facets (sides in the plane, triangles in space) with their inner side on the left (in space:
/// seen counterclockwise from outside). Facets that share an edge share its vertices.
template <int dim>
struct Boundary {
  using Facet = std::array<int, dim>;

  Field position;             ///< positions of the undeformed vertices [m]
  std::vector<Facet> facets;  ///< vertices of each
  std::vector<double> area;   ///< surface area of each vertex [m^(dim-1)]
  /// In space: the edges of each facet, opposite to its vertices; none in the plane.
  std::vector<std::array<int, 3>> edges;
  int edge_count = 0;

  /// @param longest edge of a facet [m]
  Boundary(const Shape<dim>& shape, double longest);
};

}  // namespace cosurge::contact
