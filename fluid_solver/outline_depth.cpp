#include "fluid_solver/outline_depth.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge::fluid {
namespace {

constexpr double rounding = 1e-5;  // tolerance for outlines written with seven digits [spacings]
constexpr double exact = 2e-3;     // [spacings]

template <int dim>
bool reaches_into(const Facet<dim>& facet, const Box<dim>& tank, double spacing) {
  Vec<dim> low = facet[0], high = facet[0];
  for (const Vec<dim>& corner : facet) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double margin = rounding * spacing;
  const bool above_floor = (high.array() > tank.min.array() + margin).all();
  return above_floor && (low.array() < tank.max.array() - margin).template head<dim - 1>().all();
}

/// Whether all corners have one coordinate in common, a multiple of the spacing.
template <int dim>
bool on_cell_faces(const Facet<dim>& facet, double spacing) {
  for (int axis = 0; axis < dim; ++axis) {
    const double plane = std::round(facet[0][axis] / spacing) * spacing;
    if (std::all_of(facet.begin(), facet.end(), [&](const Vec<dim>& corner) {
          return std::abs(corner[axis] - plane) < rounding * spacing;
        }))
      return true;
  }
  return false;
}

}  // namespace

template <int dim>
OutlineDepth<dim>::OutlineDepth(const Shape<dim>& shape, const std::optional<Box<dim>>& tank, double spacing)
    : shape_(shape), spacing_(spacing) {
  std::vector<Facet<dim>> wetted;
  for (const Facet<dim>& facet : shape.facets()) {
    if (tank && !reaches_into<dim>(facet, *tank, spacing)) continue;
    wetted.push_back(facet);
    if (!on_cell_faces<dim>(facet, spacing)) oblique_.push_back(facet);
  }
  wetted_ = FacetTree<dim>(wetted);
  oblique_tree_ = FacetTree<dim>(oblique_);
}

template <int dim>
Depth<dim> OutlineDepth<dim>::at(const Vec<dim>& x) const {
  const auto [point, distance_squared] = wetted_.nearest(x);
  const double distance = std::sqrt(distance_squared);
  return {.depth = shape_.contains(x) ? distance : -distance, .nearest = point};
}

template <int dim>
std::optional<Vec<dim>> OutlineDepth<dim>::at_depth(const Vec<dim>& x, double depth) const {
  Vec<dim> moved = x;
  for (int step = 0; step < 6; ++step) {
    const Depth<dim> here = at(moved);
    if (std::abs(here.depth - depth) < 1e-6 * spacing_) return moved;
    if (std::abs(here.depth) < 1e-9 * spacing_) return std::nullopt;
    moved = here.nearest + depth / here.depth * (moved - here.nearest);
    if (here.depth > depth) return moved;  // towards the nearest facet, and so it remains the nearest
  }
  if (is_at_depth(moved, depth)) return moved;
  return std::nullopt;
}

template <int dim>
bool OutlineDepth<dim>::is_at_depth(const Vec<dim>& x, double depth) const {
  return std::abs(at(x).depth - depth) < exact * spacing_;
}

template <int dim>
bool OutlineDepth<dim>::on_lattice(const Vec<dim>& x, double margin) const {
  if (oblique_.empty()) return true;
  const double nearest = std::sqrt(wetted_.nearest(x).distance_squared);
  return std::sqrt(oblique_tree_.nearest(x).distance_squared) > nearest + margin;
}

template class OutlineDepth<2>;
template class OutlineDepth<3>;

}  // namespace cosurge::fluid
