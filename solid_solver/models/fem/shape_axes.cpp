#include "solid_solver/models/fem/shape_axes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <optional>

#include "solid_solver/shape_moments.hpp"

namespace cosurge::fem {
namespace {

constexpr double alike = 1e-3;    // relative difference of principal moments below which they define no axes
constexpr double aligned = 1e-3;  // [rad] largest angle between normals of the same direction
constexpr double most_faces = 0.5;
constexpr std::size_t candidates = 8;

/// Orders the columns by the coordinates they are closest to, and directs them along these.
template <int dim>
Mat<dim> in_order(Mat<dim> left) {
  Mat<dim> axes = Mat<dim>::Zero();
  for (int k = 0; k < dim; ++k) {
    Eigen::Index nearest = 0;
    left.row(k).cwiseAbs().maxCoeff(&nearest);
    axes.col(k) = left.col(nearest) * (left(k, nearest) < 0 ? -1 : 1);
    left.col(nearest).setZero();
  }
  if (axes.determinant() < 0) axes.col(dim - 1) *= -1;
  return axes;
}

template <int dim>
Mat<dim> principal_axes(const Mat<dim>& second) {
  const Eigen::SelfAdjointEigenSolver<Mat<dim>> solver(second);
  const Vec<dim>& values = solver.eigenvalues();
  for (int k = 0; k + 1 < dim; ++k)
    if (values[k + 1] - values[k] < alike * values[dim - 1]) return Mat<dim>::Identity();
  return in_order<dim>(solver.eigenvectors());
}

/// A direction, and the area of the surface whose normals are parallel to it.
template <int dim>
struct Direction {
  Vec<dim> normal;
  double surface;
};

/// The directions of an outline's normals, in descending order of area.
template <int dim>
std::vector<Direction<dim>> directions(const Shape<dim>& shape) {
  std::vector<Direction<dim>> all;
  for (const auto& facet : shape.facets()) {
    const Vec<dim> normal = normal_of(facet);
    const double surface = normal.norm();
    if (surface == 0) continue;
    const auto same = std::find_if(all.begin(), all.end(), [&](const Direction<dim>& one) {
      const double along = one.normal.dot(normal) / surface;
      return 1 - along * along < aligned * aligned;
    });
    if (same == all.end())
      all.push_back({normal / surface, surface});
    else
      same->surface += surface;
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.surface > b.surface; });
  return all;
}

/// Axes from a direction, the largest direction normal to it, and the normal of both; nothing without such a
/// direction.
template <int dim>
std::optional<Mat<dim>> axes_from(const Vec<dim>& first, const std::vector<Direction<dim>>& all) {
  const auto across = std::find_if(all.begin(), all.end(), [&](const Direction<dim>& one) {
    return std::abs(one.normal.dot(first)) < aligned;
  });
  if (across == all.end()) return std::nullopt;
  Mat<dim> axes;
  axes.col(0) = first;
  axes.col(1) = (across->normal - across->normal.dot(first) * first).normalized();
  if constexpr (dim == 3) axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// Axes from one of the largest directions, if they contain most of the surface.
template <int dim>
std::optional<Mat<dim>> face_axes(const Shape<dim>& shape) {
  const std::vector<Direction<dim>> all = directions(shape);
  double whole = 0;
  for (const Direction<dim>& one : all) whole += one.surface;
  double most = most_faces * whole;
  std::optional<Mat<dim>> best;
  for (std::size_t k = 0; k < std::min(all.size(), candidates); ++k) {
    const auto axes = axes_from<dim>(all[k].normal, all);
    if (!axes) continue;
    double along = 0;
    for (const Direction<dim>& one : all)
      if (((axes->transpose() * one.normal).cwiseAbs().array() > 1 - aligned * aligned).any())
        along += one.surface;
    if (along <= (1 + aligned) * most) continue;
    most = along;
    best = in_order<dim>(*axes);
  }
  return best;
}

}  // namespace

template <int dim>
Mat<dim> axes_of(const Shape<dim>& shape) {
  if (shape.is_box()) return Mat<dim>::Identity();
  if (const auto axes = face_axes(shape)) return *axes;
  return principal_axes<dim>(ShapeMoments<dim>(shape).second);
}

template Mat<2> axes_of<2>(const Shape<2>&);
template Mat<3> axes_of<3>(const Shape<3>&);

}  // namespace cosurge::fem
