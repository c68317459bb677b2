#include "solid_solver/contact/facet_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cosurge::contact {
namespace {

/// Shares of the ends in the point of a side that is nearest to x.
std::array<double, 2> nearest_shares(const Vec<2>& x, const std::array<Vec<2>, 2>& side) {
  const Vec<2> along = side[1] - side[0];
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp((x - side[0]).dot(along) / square, 0.0, 1.0) : 0;
  return {1 - share, share};
}

/// The same of a triangle (Ericson 2005, Real-Time Collision Detection, section 5.1.5).
std::array<double, 3> nearest_shares(const Vec<3>& x, const std::array<Vec<3>, 3>& t) {
  const Vec<3> ab = t[1] - t[0], ac = t[2] - t[0];
  const double d1 = ab.dot(x - t[0]), d2 = ac.dot(x - t[0]);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = ab.dot(x - t[1]), d4 = ac.dot(x - t[1]);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double d5 = ab.dot(x - t[2]), d6 = ac.dot(x - t[2]);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - share, share};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0)) return {1, 0, 0};  // a triangle that has become a point
  return {1 - vb / sum - vc / sum, vb / sum, vc / sum};
}

}  // namespace

template <int dim>
FacetSearch<dim>::FacetSearch(const Boundary<dim>& boundary, const Eigen::Ref<const Field>& position,
                              double reach, const Box<dim>& region)
    : boundary_(&boundary), position_(position), reach_(reach) {
  sum_normals();
  for (int f = 0; f < static_cast<int>(boundary.facets.size()); ++f) {
    Vec<dim> lower = vertex(f, 0), upper = lower;
    for (std::size_t k = 1; k < dim; ++k) {
      lower = lower.cwiseMin(vertex(f, k));
      upper = upper.cwiseMax(vertex(f, k));
    }
    if ((lower.array() > region.max.array() + reach).any() ||
        (upper.array() < region.min.array() - reach).any())
      continue;
    visit_cells(lower, upper, [&](const Cell& cell) { facets_.emplace_back(cell, f); });
  }
  std::sort(facets_.begin(), facets_.end());
}

template <int dim>
typename FacetSearch<dim>::Cell FacetSearch<dim>::cell_of(const Vec<dim>& x) const {
  Cell cell;
  for (int k = 0; k < dim; ++k) cell[k] = static_cast<int>(std::floor(x[k] / (2 * reach_)));
  return cell;
}

template <int dim>
template <typename Visit>
void FacetSearch<dim>::visit_cells(const Vec<dim>& lower, const Vec<dim>& upper, const Visit& visit) const {
  const Cell first = cell_of(lower), last = cell_of(upper);
  Cell cell = first;
  for (std::size_t axis = 0; axis < dim;) {
    visit(cell);
    for (axis = 0; axis < dim && ++cell[axis] > last[axis]; ++axis) cell[axis] = first[axis];
  }
}

template <int dim>
void FacetSearch<dim>::sum_normals() {
  const auto& facets = boundary_->facets;
  facet_normal_.reserve(facets.size());
  edge_normal_.assign(static_cast<std::size_t>(boundary_->edge_count), Vec<dim>::Zero());
  vertex_normal_.assign(static_cast<std::size_t>(position_.cols()), Vec<dim>::Zero());
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    typename Shape<dim>::Facet corner;
    for (std::size_t k = 0; k < dim; ++k) corner[k] = vertex(f, k);
    const Vec<dim> normal = normal_of(corner).normalized();
    facet_normal_.push_back(normal);
    Vec<dim> middle = Vec<dim>::Zero();
    for (const Vec<dim>& x : corner) middle += x / dim;
    double radius = 0;
    for (const Vec<dim>& x : corner) radius = std::max(radius, (x - middle).norm());
    middle_.push_back(middle);
    radius_.push_back(radius);
    for (std::size_t k = 0; k < dim; ++k) {
      double angle = 1;
      if constexpr (dim == 3) {
        const Vec<3> a = corner[(k + 1) % 3] - corner[k], b = corner[(k + 2) % 3] - corner[k];
        angle = std::atan2(a.cross(b).norm(), a.dot(b));
        edge_normal_[static_cast<std::size_t>(boundary_->edges[static_cast<std::size_t>(f)][k])] += normal;
      }
      vertex_normal_[static_cast<std::size_t>(facets[static_cast<std::size_t>(f)][k])] += angle * normal;
    }
  }
}

template <int dim>
Vec<dim> FacetSearch<dim>::normal_at(int facet, const std::array<double, dim>& share) const {
  const auto f = static_cast<std::size_t>(facet);
  const auto none = std::count(share.begin(), share.end(), 0.0);
  if (none == 0) return facet_normal_[f];
  if (none == dim - 1) {
    const auto corner = std::max_element(share.begin(), share.end()) - share.begin();
    return vertex_normal_[static_cast<std::size_t>(boundary_->facets[f][static_cast<std::size_t>(corner)])];
  }
  const auto opposite = std::find(share.begin(), share.end(), 0.0) - share.begin();
  return edge_normal_[static_cast<std::size_t>(boundary_->edges[f][static_cast<std::size_t>(opposite)])];
}

template <int dim>
std::optional<Nearest<dim>> FacetSearch<dim>::nearest(const Vec<dim>& x) const {
  double distance = reach_, least = reach_ * reach_;
  std::optional<Nearest<dim>> best;
  Vec<dim> way;
  const Vec<dim> reach = Vec<dim>::Constant(reach_);
  visit_cells(x - reach, x + reach, [&](const Cell& cell) {
    auto entry = std::lower_bound(facets_.begin(), facets_.end(), std::pair<Cell, int>(cell, 0));
    for (; entry != facets_.end() && entry->first == cell; ++entry) {
      const auto f = static_cast<std::size_t>(entry->second);
      const double farthest = distance + radius_[f];
      if ((x - middle_[f]).squaredNorm() > farthest * farthest) continue;
      typename Shape<dim>::Facet corner;
      for (std::size_t k = 0; k < dim; ++k) corner[k] = vertex(entry->second, k);
      const auto share = nearest_shares(x, corner);
      Vec<dim> from = x;
      for (std::size_t k = 0; k < dim; ++k) from -= share[k] * corner[k];
      if (from.squaredNorm() >= least) continue;
      least = from.squaredNorm();
      distance = std::sqrt(least);
      way = from;
      best = {.gap = 0, .normal = {}, .facet = entry->second, .share = share};
    }
  });
  if (!best) return best;
  const Vec<dim> outwards = normal_at(best->facet, best->share);
  const double side = way.dot(outwards) < 0 ? -1 : 1;
  best->gap = side * distance;
  constexpr double rounding = 1e-9;  // [reach]; a shorter way has no direction
  best->normal = distance > rounding * reach_ ? Vec<dim>(side / distance * way) : outwards.normalized();
  return best;
}

template class FacetSearch<2>;
template class FacetSearch<3>;

}  // namespace cosurge::contact
