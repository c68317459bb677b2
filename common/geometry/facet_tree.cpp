#include "common/geometry/facet_tree.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <numeric>

namespace cosurge {
namespace {

constexpr std::int32_t leaf_size = 4;

/// How the ray from x along the first coordinate crosses the side from a to b: 1 from its inner to its outer
/// side, -1 the other way, 0 not. Its lower end counts, its upper one not.
int crossing(const Vec<2>& x, const Facet<2>& side) {
  const auto& [a, b] = side;
  if ((a[1] > x[1]) == (b[1] > x[1])) return 0;
  if (!(x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))) return 0;
  return b[1] > a[1] ? 1 : -1;
}

/// The same of a triangle.
int crossing(const Vec<3>& x, const Facet<3>& triangle) {
  const auto& [a, b, c] = triangle;
  Mat<2> edges;
  edges.col(0) = (b - a).tail<2>();
  edges.col(1) = (c - a).tail<2>();
  const double determinant = edges.determinant();
  if (determinant == 0) return 0;
  const Vec<2> share = edges.inverse() * (x - a).tail<2>();
  if (share[0] < 0 || share[1] < 0 || share.sum() > 1) return 0;
  if (!(x[0] < a[0] + share[0] * (b[0] - a[0]) + share[1] * (c[0] - a[0]))) return 0;
  return determinant > 0 ? 1 : -1;
}

template <int dim>
Vec<dim> nearest_on_segment(const Vec<dim>& x, const Vec<dim>& a, const Vec<dim>& b) {
  const double length_squared = (b - a).squaredNorm();
  if (length_squared == 0) return a;
  return a + std::clamp((x - a).dot(b - a) / length_squared, 0.0, 1.0) * (b - a);
}

Vec<2> nearest_on(const Vec<2>& x, const Facet<2>& side) {
  return nearest_on_segment<2>(x, side[0], side[1]);
}

/// The foot of the perpendicular, or where that misses the triangle the nearest point of its edges.
Vec<3> nearest_on(const Vec<3>& x, const Facet<3>& triangle) {
  const Vec<3> normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double twice_area = normal.norm();
  bool inside = twice_area > 0;
  Vec<3> best = triangle[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec<3>&a = triangle[k], &b = triangle[(k + 1) % 3];
    const Vec<3> on_edge = nearest_on_segment<3>(x, a, b);
    if ((on_edge - x).squaredNorm() < (best - x).squaredNorm()) best = on_edge;
    inside = inside && (b - a).cross(x - a).dot(normal) >= 0;
  }
  return inside ? Vec<3>(x - (x - triangle[0]).dot(normal) / (twice_area * twice_area) * normal) : best;
}

template <int dim>
Vec<dim> centroid(const Facet<dim>& facet) {
  Vec<dim> sum = Vec<dim>::Zero();
  for (const Vec<dim>& corner : facet) sum += corner;
  return sum / dim;
}

}  // namespace

template <int dim>
FacetTree<dim>::FacetTree(const std::vector<Facet<dim>>& facets) : facets_(facets), number_(facets.size()) {
  std::iota(number_.begin(), number_.end(), 0);
  if (facets.empty()) return;
  build(0, static_cast<std::int32_t>(facets.size()));
  for (std::size_t k = 0; k < facets.size(); ++k) facets_[k] = facets[static_cast<std::size_t>(number_[k])];
}

/// Adds the node of the facets `first` to `last` of the order, and its children; halves at the median.
template <int dim>
void FacetTree<dim>::build(std::int32_t first, std::int32_t last) {
  const auto facet = [&](std::int32_t k) -> const Facet<dim>& {
    return facets_[static_cast<std::size_t>(k)];
  };
  Node node{.min = Vec<dim>::Constant(std::numeric_limits<double>::max()),
            .max = Vec<dim>::Constant(std::numeric_limits<double>::lowest()),
            .first = first,
            .last = last,
            .right = 0};
  for (std::int32_t k = first; k < last; ++k)
    for (const Vec<dim>& corner : facet(number_[static_cast<std::size_t>(k)])) {
      node.min = node.min.cwiseMin(corner);
      node.max = node.max.cwiseMax(corner);
    }
  const std::size_t place = nodes_.size();
  nodes_.push_back(node);
  if (last - first <= leaf_size) return;
  Eigen::Index axis = 0;
  (node.max - node.min).maxCoeff(&axis);
  const std::int32_t middle = first + (last - first) / 2;
  std::nth_element(number_.begin() + first, number_.begin() + middle, number_.begin() + last,
                   [&](std::int32_t a, std::int32_t b) {
                     const double at = centroid<dim>(facet(a))[axis], bt = centroid<dim>(facet(b))[axis];
                     return at < bt || (at == bt && a < b);
                   });
  build(first, middle);
  nodes_[place].right = static_cast<std::int32_t>(nodes_.size());
  build(middle, last);
}

template <int dim>
auto FacetTree<dim>::nearest(const Vec<dim>& x) const -> Nearest {
  Nearest best{.point = x, .distance_squared = std::numeric_limits<double>::infinity()};
  if (nodes_.empty()) return best;
  std::int32_t number = 0;
  // A facet may be nearer than its box by rounding.
  const auto away = [&](std::int32_t n) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    return (1 - 1e-9) * (x - x.cwiseMax(node.min).cwiseMin(node.max)).squaredNorm();
  };
  std::array<std::int32_t, 64> stack{};
  std::size_t open = 1;
  while (open > 0) {
    const std::int32_t n = stack[--open];
    if (away(n) > best.distance_squared) continue;
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    if (node.right != 0) {
      const bool swap = away(n + 1) < away(node.right);
      stack[open++] = swap ? node.right : n + 1;
      stack[open++] = swap ? n + 1 : node.right;
      continue;
    }
    for (auto k = static_cast<std::size_t>(node.first); k < static_cast<std::size_t>(node.last); ++k) {
      const Vec<dim> on = nearest_on(x, facets_[k]);
      const double d = (on - x).squaredNorm();
      if (d > best.distance_squared || (d == best.distance_squared && number_[k] > number)) continue;
      best = {.point = on, .distance_squared = d};
      number = number_[k];
    }
  }
  return best;
}

template <int dim>
int FacetTree<dim>::crossings(const Vec<dim>& x) const {
  int sum = 0;
  std::array<std::int32_t, 64> stack{};
  std::size_t open = nodes_.empty() ? 0 : 1;
  while (open > 0) {
    const std::int32_t n = stack[--open];
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    bool met = x[0] <= node.max[0];
    for (int axis = 1; axis < dim; ++axis)
      met = met && x[axis] >= node.min[axis] && x[axis] <= node.max[axis];
    if (!met) continue;
    if (node.right != 0) {
      stack[open++] = node.right;
      stack[open++] = n + 1;
      continue;
    }
    for (auto k = static_cast<std::size_t>(node.first); k < static_cast<std::size_t>(node.last); ++k)
      sum += crossing(x, facets_[k]);
  }
  return sum;
}

template class FacetTree<2>;
template class FacetTree<3>;

}  // namespace cosurge
