#include "fluid_solver/bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <utility>

#include "fluid_solver/point_hash.hpp"
#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

/// Area of the faces of a site's cell that neither its body, nor clamps, nor the tank cover.
template <int dim>
LatticeFaces<dim> wet_faces(const Vec<dim>& x, const BodySites<dim>& body,
                            const std::vector<Shape<dim>>& clamps, const Box<dim>& tank, double spacing) {
  LatticeFaces<dim> wet{.below = Vec<dim>::Zero(), .above = Vec<dim>::Zero()};
  for (int axis = 0; axis < dim; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Vec<dim> across = x;
      across[axis] += side * spacing;
      const bool dry = body.contains(across) ||
                       std::any_of(clamps.begin(), clamps.end(),
                                   [&](const Shape<dim>& clamp) { return clamp.contains(across); });
      const bool walled = (axis < dim - 1 || side < 0) && !tank.contains(across);
      if (!dry && !walled) (side < 0 ? wet.below : wet.above)[axis] = std::pow(spacing, dim - 1);
    }
  }
  return wet;
}

/// Number of the point that is nearest to x, of equally near ones the first; -1 if none is within reach.
template <int dim>
int nearest_of(const PointHash<dim>& points, const Vec<dim>& x) {
  std::pair nearest(std::numeric_limits<double>::max(), std::int32_t{-1});
  points.near(x, [&](std::int32_t n, double) {
    nearest = std::min(nearest, std::pair((points.points()[n] - x).squaredNorm(), n));
  });
  return nearest.second;
}

}  // namespace

template <int dim>
Bodies<dim>::Bodies(const std::vector<WetBody<dim>>& bodies, const Box<dim>& tank, double spacing) {
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    held_at_rest_.push_back(bodies[b].held_at_rest);
    const BodySites<dim> sites(bodies[b].shape, spacing);
    for (const Vec<dim>& x : sites.all()) {
      position_.push_back(x);
      const LatticeFaces<dim> wet = wet_faces(x, sites, bodies[b].clamps, tank, spacing);
      area_.push_back(wet.above - wet.below);
      normal_.push_back(bodies[b].shape.is_box() ? area_.back()
                                                 : Vec<dim>((bodies[b].shape.nearest(x) - x).normalized()));
      faces_.push_back(wet);
      body_.push_back(static_cast<int>(b));
    }
  }
  find_neighbors(spacing);
  find_nearest_wet(spacing);
}

template <int dim>
void Bodies<dim>::find_neighbors(double spacing) {
  const double reach = 2.1 * spacing;  // two layers: F stays well conditioned at edges and corners
  PointHash<dim> all(reach);
  for (const Vec<dim>& x : position_) all.add(x);
  neighbor_begin_ = {0};
  for (int k = 0; k < points(); ++k) {
    if (wet(k))
      all.near(position_[k], [&](std::int32_t j, double) {
        if (j != k && body_[j] == body_[k]) neighbor_.push_back(j);
      });
    std::sort(neighbor_.begin() + neighbor_begin_.back(), neighbor_.end());
    neighbor_begin_.push_back(static_cast<int>(neighbor_.size()));
  }
}

template <int dim>
void Bodies<dim>::find_nearest_wet(double spacing) {
  nearest_wet_.assign(position_.size(), -1);
  for (int first = 0, end = 0; first < points(); first = end) {
    std::vector<int> wet_points, left;  // of this body: those with water, those without a nearest one yet
    for (; end < points() && body_[end] == body_[first]; ++end) {
      left.push_back(end);
      if (wet(end)) wet_points.push_back(end);
    }
    for (double reach = 2.1 * spacing; !wet_points.empty() && !left.empty(); reach *= 2) {
      PointHash<dim> surface(reach);
      for (const int w : wet_points) surface.add(position_[w]);
      std::erase_if(left, [&](int k) {
        const int nearest = nearest_of(surface, position_[k]);
        if (nearest >= 0) nearest_wet_[k] = wet_points[nearest];
        return nearest >= 0;
      });
    }
  }
}

/// J F^-T at a wet point, with F by eq. (12).
template <int dim>
Mat<dim> Bodies<dim>::cofactor(int k, const Field& displacement) const {
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
  return F.determinant() * F.inverse().transpose();
}

template <int dim>
Faces<dim> Bodies<dim>::deformed(const Field& displacement) const {
  Faces<dim> faces{.area = area_,
                   .spread = std::vector<Mat<dim>>(position_.size(), Mat<dim>::Zero()),
                   .normal = std::vector<Vec<dim>>(position_.size(), Vec<dim>::Zero()),
                   .cofactor = std::vector<Mat<dim>>(position_.size(), Mat<dim>::Zero()),
                   .open = std::vector<char>(position_.size(), 0)};
  for (int k = 0; k < points(); ++k) {
    if (!wet(k)) continue;
    faces.cofactor[k] = cofactor(k, displacement);
    faces.normal[k] = (faces.cofactor[k] * normal_[k]).normalized();
  }
  set_open(std::vector<Openness<dim>>(position_.size()), faces);
  for (int k = 0; k < points(); ++k)
    if (!wet(k) && nearest_wet_[k] >= 0) faces.normal[k] = faces.normal[nearest_wet_[k]];
  return faces;
}

template <int dim>
void Bodies<dim>::set_open(const std::vector<Openness<dim>>& open, Faces<dim>& faces) const {
  for (int k = 0; k < points(); ++k) {
    if (!wet(k)) continue;
    const Mat<dim>& J = faces.cofactor[k];
    const Vec<dim> below = faces_[k].below.cwiseProduct(open[k].below),
                   above = faces_[k].above.cwiseProduct(open[k].above);
    faces.open[k] = (above + below).isZero() ? 0 : 1;
    faces.area[k] = J * (above - below);
    faces.spread[k].setZero();
    for (int axis = 0; axis < dim; ++axis)
      faces.spread[k] +=
          (above[axis] + below[axis]) / J.col(axis).norm() * J.col(axis) * J.col(axis).transpose();
  }
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
