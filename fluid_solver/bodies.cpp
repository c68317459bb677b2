#include "fluid_solver/bodies.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

/// A_0 of the body's site x: the faces of its cell that no material and no wall covers.
template <int dim>
Vec<dim> wet_faces(const Vec<dim>& x, const BodySites<dim>& body, const std::vector<Shape<dim>>& clamps,
                   const Box<dim>& tank, double spacing) {
  Vec<dim> area = Vec<dim>::Zero();
  for (int axis = 0; axis < dim; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec<dim> across = x;
      across[axis] += side * spacing;
      const bool dry = body.contains(across) ||
                       std::any_of(clamps.begin(), clamps.end(),
                                   [&](const Shape<dim>& clamp) { return clamp.contains(across); });
      const bool walled = (axis < dim - 1 || side < 0) && !tank.contains(across);
      if (!dry && !walled) area[axis] += side;
    }
  }
  return std::pow(spacing, dim - 1) * area;
}

}  // namespace

template <int dim>
Bodies<dim>::Bodies(const v1::Solid& solid, const Box<dim>& tank, double spacing) {
  for (int b = 0; b < solid.body_size(); ++b) {
    const v1::Body& body = solid.body(b);
    const BodySites<dim> sites(body, spacing);
    const std::vector<Shape<dim>> clamps(body.clamp().begin(), body.clamp().end());
    for (const Vec<dim>& x : sites.all()) {
      position_.push_back(x);
      area_.push_back(wet_faces(x, sites, clamps, tank, spacing));
      body_.push_back(b);
    }
  }
  find_neighbors(spacing);
}

template <int dim>
void Bodies<dim>::find_neighbors(double spacing) {
  const double reach = 2.1 * spacing;  // two layers: F stays well conditioned at edges and corners
  neighbor_begin_ = {0};
  for (int k = 0; k < points(); ++k) {
    for (int j = 0; wet(k) && j < points(); ++j)
      if (j != k && body_[j] == body_[k] && (position_[j] - position_[k]).norm() < reach)
        neighbor_.push_back(j);
    neighbor_begin_.push_back(static_cast<int>(neighbor_.size()));
  }
}

template <int dim>
std::vector<Vec<dim>> Bodies<dim>::deformed_areas(const Field& displacement) const {
  std::vector<Vec<dim>> areas(area_);
  for (int k = 0; k < points(); ++k) {
    if (!wet(k)) continue;
    Mat<dim> deformed = Mat<dim>::Zero();
    Mat<dim> reference = Mat<dim>::Zero();
    for (int n = neighbor_begin_[k]; n < neighbor_begin_[k + 1]; ++n) {
      const int j = neighbor_[n];
      const Vec<dim> X_kj = position_[j] - position_[k];
      const Vec<dim> x_kj = X_kj + displacement.col(j) - displacement.col(k);
      const double w = 1.0 / X_kj.squaredNorm();
      deformed += w * x_kj * X_kj.transpose();
      reference += w * X_kj * X_kj.transpose();
    }
    const Mat<dim> F = deformed * reference.inverse();
    areas[k] = F.determinant() * F.inverse().transpose() * area_[k];
  }
  return areas;
}

template <int dim>
Interface Bodies<dim>::interface() const {
  Interface result{
      .dimension = dim, .position = Field(dim, points()), .area = Field(dim, points()), .body = body_};
  for (int k = 0; k < points(); ++k) {
    result.position.col(k) = position_[k];
    result.area.col(k) = area_[k];
  }
  return result;
}

template class Bodies<2>;
template class Bodies<3>;

}  // namespace cosurge::fluid
