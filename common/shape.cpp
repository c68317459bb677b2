#include "common/shape.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "common/triangles.hpp"

namespace cosurge {

Vec<2> normal_of(const Shape<2>::Facet& side) { return {side[1][1] - side[0][1], side[0][0] - side[1][0]}; }

Vec<3> normal_of(const Shape<3>::Facet& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
}
namespace {

constexpr double on_the_face = 1e-9;  // m: what lies on a face lies in the body whatever the rounding

template <int dim>
Box<dim> bounds_of(const v1::Shape& shape) {
  if (shape.vertex().empty())
    return {Eigen::Map<const Vec<dim>>(shape.min().data()), Eigen::Map<const Vec<dim>>(shape.max().data())};
  const Eigen::Map<const Eigen::Matrix<double, dim, Eigen::Dynamic>> vertices(shape.vertex().data(), dim,
                                                                              shape.vertex_size() / dim);
  return {vertices.rowwise().minCoeff(), vertices.rowwise().maxCoeff()};
}

/// How the ray from x along the first coordinate crosses the side from a to b: 1 from its inner to its outer
/// side, -1 the other way, 0 not. Its lower end counts, its upper one not.
int crossing(const Vec<2>& x, const std::array<Vec<2>, 2>& side) {
  const auto& [a, b] = side;
  if ((a[1] > x[1]) == (b[1] > x[1])) return 0;
  if (!(x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))) return 0;
  return b[1] > a[1] ? 1 : -1;
}

/// The same of a triangle.
int crossing(const Vec<3>& x, const std::array<Vec<3>, 3>& triangle) {
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

Vec<2> nearest_on(const Vec<2>& x, const std::array<Vec<2>, 2>& side) {
  return nearest_on_segment<2>(x, side[0], side[1]);
}

/// The foot of the perpendicular, or where that misses the triangle the nearest point of its edges.
Vec<3> nearest_on(const Vec<3>& x, const std::array<Vec<3>, 3>& triangle) {
  const Vec<3> normal = normal_of(triangle);
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
    return Vec<dim>(Eigen::Map<const Vec<dim>>(shape.vertex().data() + k % corners * dim));
  };
  if constexpr (dim == 2)
    for (int k = 0; k < corners; ++k) facets_.push_back({corner(k), corner(k + 1)});
  else
    for (int k = 0; k + 2 < corners; k += 3) facets_.push_back({corner(k), corner(k + 1), corner(k + 2)});
  if constexpr (dim == 3) oriented_ = is_oriented(facets_);
}

template <int dim>
bool Shape<dim>::contains(const Vec<dim>& x) const {
  return bounds_.contains(x) && (is_box() || winding(x) != 0);
}

template <int dim>
int Shape<dim>::winding(const Vec<dim>& x) const {
  if (is_box()) return bounds_.contains(x) ? 1 : 0;
  Vec<dim> start = x;
  // A little aside of where edges lie: a ray along the edge of two triangles would meet both or none.
  if constexpr (dim == 3) start += 1e-9 * (bounds_.max - bounds_.min).norm() * Vec<3>(0, 1, 0.618);
  int sum = 0;
  for (const Facet& facet : facets_) sum += crossing(start, facet);
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
  Vec<dim> best = x;
  double least = std::numeric_limits<double>::infinity();
  for (const Facet& facet : facets_) {
    const Vec<dim> on = nearest_on(x, facet);
    if ((on - x).squaredNorm() >= least) continue;
    least = (on - x).squaredNorm();
    best = on;
  }
  return best;
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
