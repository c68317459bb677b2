// A tree of bounding boxes around the facets of an outline.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/vec.hpp"

namespace cosurge {

/// A side of a polygon, or a triangle.
template <int dim>
using Facet = std::array<Vec<dim>, dim>;

/// Finds the facet that is nearest to a point, and the facets that a ray meets, in a time that grows with the
/// logarithm of their number. The results are bit-identical to those of a search through all facets.
template <int dim>
class FacetTree {
 public:
  struct Nearest {
    Vec<dim> point;           // nearest point on the facets
    double distance_squared;  // infinite where there are no facets
  };

  FacetTree() = default;
  explicit FacetTree(const std::vector<Facet<dim>>& facets);

  bool empty() const { return facets_.empty(); }

  Nearest nearest(const Vec<dim>& x) const;

  /// How many facets the ray from x along the first coordinate crosses outwards, less those that it crosses
  /// inwards.
  int crossings(const Vec<dim>& x) const;

 private:
  struct Node {
    Vec<dim> min, max;
    std::int32_t first, last;  // facets
    std::int32_t right;        // second child; the first child is the next node; 0: a leaf
  };

  void build(std::int32_t first, std::int32_t last);

  std::vector<Facet<dim>> facets_;    // in the order of the leaves
  std::vector<std::int32_t> number_;  // index of each facet in the order given
  std::vector<Node> nodes_;
};

}  // namespace cosurge
