#include "common/geometry/shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "common/geometry/triangles.hpp"

namespace cosurge {

Vec<2> normal_of(const Shape<2>::Facet& side) { return {side[1][1] - side[0][1], side[0][0] - side[1][0]}; }

Vec<3> normal_of(const Shape<3>::Facet& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
}

template <int dim>
Shape<dim>::Shape(const std::vector<Vec<dim>>& corners) : bounds_(corners.front(), corners.front()) {
  for (const Vec<dim>& corner : corners) {
    bounds_.min = bounds_.min.cwiseMin(corner);
    bounds_.max = bounds_.max.cwiseMax(corner);
  }
  if constexpr (dim == 2)
    for (std::size_t k = 0; k < corners.size(); ++k)
      facets_.push_back({corners[k], corners[(k + 1) % corners.size()]});
  else
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
      facets_.push_back({corners[k], corners[k + 1], corners[k + 2]});
  index_facets();
}

template <int dim>
void Shape<dim>::index_facets() {
  if constexpr (dim == 3) oriented_ = is_oriented(facets_);
  tree_ = FacetTree<dim>(facets_);
}

template <int dim>
Shape<dim> Shape<dim>::moved(const Vec<dim>& by) const {
  Shape there = *this;
  there.bounds_ = {bounds_.min + by, bounds_.max + by};
  for (Facet& facet : there.facets_)
    for (Vec<dim>& corner : facet) corner += by;
  there.index_facets();
  return there;
}

template <int dim>
bool Shape<dim>::contains(const Vec<dim>& x) const {
  return bounds_.contains(x) && (is_box() || winding(x) != 0);
}

template <int dim>
int Shape<dim>::winding(const Vec<dim>& x) const {
  if (is_box()) return bounds_.contains(x) ? 1 : 0;
  // A little aside of where faces and edges lie: rounding would decide about each point on a face, and a ray
  // along the edge of two triangles would meet both or none. Points on a face below the body are inside, on
  // one above it outside, so that the sites of a lattice keep their mean volume.
  Vec<dim> aside = Vec<dim>::Unit(dim - 1);
  aside[dim - 2] = 1e-3;  // for upright faces
  const int sum = tree_.crossings(x + 1e-9 * (bounds_.max - bounds_.min).norm() * aside);
  return oriented_ ? sum : std::abs(sum) % 2;
}

template <int dim>
Vec<dim> Shape<dim>::nearest(const Vec<dim>& x) const {
  if (is_box()) {
    Vec<dim> on = x.cwiseMax(bounds_.min).cwiseMin(bounds_.max);
    if (on != x) return on;
    Eigen::Index low = 0, high = 0;
    const double below = (x - bounds_.min).minCoeff(&low), above = (bounds_.max - x).minCoeff(&high);
    if (below < above)
      on[low] = bounds_.min[low];
    else
      on[high] = bounds_.max[high];
    return on;
  }
  return tree_.nearest(x).point;
}

template <int dim>
double Shape<dim>::outside(const Vec<dim>& x) const {
  return contains(x) ? 0 : (x - nearest(x)).cwiseAbs().maxCoeff();
}

template <int dim>
double Shape<dim>::share_outside(const Vec<dim>& x, const Vec<dim>& way) const {
  double out = 0, in = 1;
  if (is_box()) {
    for (int k = 0; k < dim; ++k) {
      if (x[k] < bounds_.min[k]) out = std::max(out, (bounds_.min[k] - x[k]) / way[k]);
      if (x[k] > bounds_.max[k]) out = std::max(out, (bounds_.max[k] - x[k]) / way[k]);
    }
    return out;
  }
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (out + in);
    (contains(x + middle * way) ? in : out) = middle;
  }
  return in;
}

template <int dim>
std::vector<Vec<dim>> Shape<dim>::fill(double spacing) const {
  if (is_box()) return cosurge::fill(bounds_, spacing);
  const Vec<dim> margin = Vec<dim>::Constant(spacing);
  std::vector<Vec<dim>> sites;
  for (const Vec<dim>& x : cosurge::fill(Box<dim>(bounds_.min - margin, bounds_.max + margin), spacing))
    if (contains(x)) sites.push_back(x);
  return sites;
}

template class Shape<2>;
template class Shape<3>;

}  // namespace cosurge
