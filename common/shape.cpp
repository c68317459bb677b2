#include "common/shape.hpp"

#include <Eigen/LU>

namespace cosurge {
namespace {

template <int dim>
Box<dim> bounds_of(const v1::Shape& shape) {
  if (shape.vertex().empty())
    return {Eigen::Map<const Vec<dim>>(shape.min().data()), Eigen::Map<const Vec<dim>>(shape.max().data())};
  const Eigen::Map<const Eigen::Matrix<double, dim, Eigen::Dynamic>> vertices(shape.vertex().data(), dim,
                                                                              shape.vertex_size() / dim);
  return {vertices.rowwise().minCoeff(), vertices.rowwise().maxCoeff()};
}

/// Whether the ray from x along the first coordinate crosses the side from a to b; its lower end counts, its
/// upper one not.
bool crosses(const Vec<2>& x, const Vec<2>& a, const Vec<2>& b) {
  if ((a[1] > x[1]) == (b[1] > x[1])) return false;
  return x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
}

/// Whether the ray from x along the first coordinate crosses the triangle a b c.
bool crosses(const Vec<3>& x, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  Mat<2> edges;
  edges.col(0) = (b - a).tail<2>();
  edges.col(1) = (c - a).tail<2>();
  const double determinant = edges.determinant();
  if (determinant == 0) return false;
  const Vec<2> share = edges.inverse() * (x - a).tail<2>();
  if (share[0] < 0 || share[1] < 0 || share.sum() > 1) return false;
  return x[0] < a[0] + share[0] * (b[0] - a[0]) + share[1] * (c[0] - a[0]);
}

}  // namespace

template <int dim>
Shape<dim>::Shape(const v1::Shape& shape) : bounds_(bounds_of<dim>(shape)) {
  for (int k = 0; k < shape.vertex_size(); k += dim)
    vertex_.emplace_back(Eigen::Map<const Vec<dim>>(shape.vertex().data() + k));
}

template <int dim>
bool Shape<dim>::contains(const Vec<dim>& x) const {
  if (!bounds_.contains(x)) return false;
  if (vertex_.empty()) return true;
  int crossings = 0;
  if constexpr (dim == 2) {
    for (std::size_t k = 0; k < vertex_.size(); ++k)
      crossings += crosses(x, vertex_[k], vertex_[(k + 1) % vertex_.size()]) ? 1 : 0;
  } else {
    // A little aside of where edges lie: a ray along the edge of two triangles would meet both or none.
    const Vec<3> aside = x + 1e-9 * (bounds_.max - bounds_.min).norm() * Vec<3>(0, 1, 0.618);
    for (std::size_t k = 0; k + 2 < vertex_.size(); k += 3)
      crossings += crosses(aside, vertex_[k], vertex_[k + 1], vertex_[k + 2]) ? 1 : 0;
  }
  return crossings % 2 == 1;
}

template <int dim>
std::vector<Vec<dim>> Shape<dim>::fill(double spacing) const {
  if (vertex_.empty()) return cosurge::fill(bounds_, spacing);
  const Vec<dim> margin = Vec<dim>::Constant(spacing);
  std::vector<Vec<dim>> sites;
  for (const Vec<dim>& x : cosurge::fill(Box<dim>(bounds_.min - margin, bounds_.max + margin), spacing))
    if (contains(x)) sites.push_back(x);
  return sites;
}

template class Shape<2>;
template class Shape<3>;

}  // namespace cosurge
