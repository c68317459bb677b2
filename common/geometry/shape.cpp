#include "common/geometry/shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "common/geometry/triangles.hpp"

namespace cosurge {

Vec<2> normal_of(const Shape<2>::Facet& side) { return {side[1][1] - side[0][1], side[0][0] - side[1][0]}; }

Vec<3> normal_of(const Shape<3>::Facet& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
}
namespace {

constexpr double on_the_face = 1e-9;  // [m] tolerance: points on a face count as inside

template <int dim>
Box<dim> bounds_of(const v1::Shape& shape) {
  if (shape.vertex().empty())
    return {Eigen::Map<const Vec<dim>>(shape.min().data()), Eigen::Map<const Vec<dim>>(shape.max().data())};
  const Eigen::Map<const Eigen::Matrix<double, dim, Eigen::Dynamic>> vertices(shape.vertex().data(), dim,
                                                                              shape.vertex_size() / dim);
  return {vertices.rowwise().minCoeff(), vertices.rowwise().maxCoeff()};
}

template <int dim>
int first_body_at(const v1::Solid& solid, const Vec<dim>& x) {
  for (int b = 0; b < solid.body_size(); ++b)
    if (Shape<dim>(shape_of(solid.body(b))).outside(x) <= on_the_face) return b;
  return -1;
}

}  // namespace

template <int dim>
Shape<dim>::Shape(const v1::Shape& shape) : bounds_(bounds_of<dim>(shape)) {
  const int corners = shape.vertex_size() / dim;
  const auto corner = [&](int k) {
    return Vec<dim>(Eigen::Map<const Vec<dim>>(shape.vertex().data() + std::ptrdiff_t{k % corners} * dim));
  };
  if constexpr (dim == 2)
    for (int k = 0; k < corners; ++k) facets_.push_back({corner(k), corner(k + 1)});
  else
    for (int k = 0; k + 2 < corners; k += 3) facets_.push_back({corner(k), corner(k + 1), corner(k + 2)});
  if constexpr (dim == 3) oriented_ = is_oriented(facets_);
  tree_ = FacetTree<dim>(facets_);
}

template <int dim>
bool Shape<dim>::contains(const Vec<dim>& x) const {
  return bounds_.contains(x) && (is_box() || winding(x) != 0);
}

template <int dim>
int Shape<dim>::winding(const Vec<dim>& x) const {
  if (is_box()) return bounds_.contains(x) ? 1 : 0;
  // A little aside of where edges lie: a ray along the edge of two triangles would meet both or none.
  Vec<dim> aside = Vec<dim>::Zero();
  if constexpr (dim == 3) aside = 1e-9 * (bounds_.max - bounds_.min).norm() * Vec<3>(0, 1, 0.618);
  const int sum = tree_.crossings(x + aside);
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

v1::Shape shape_of(const v1::Box& box) {
  v1::Shape shape;
  *shape.mutable_min() = box.min();
  *shape.mutable_max() = box.max();
  return shape;
}

v1::Shape shape_of(const v1::Body& body) { return body.has_shape() ? body.shape() : shape_of(body.box()); }

int body_at(const v1::Solid& solid, const google::protobuf::RepeatedField<double>& position) {
  return position.size() == 2 ? first_body_at<2>(solid, Eigen::Map<const Vec<2>>(position.data()))
                              : first_body_at<3>(solid, Eigen::Map<const Vec<3>>(position.data()));
}

template class Shape<2>;
template class Shape<3>;

}  // namespace cosurge
