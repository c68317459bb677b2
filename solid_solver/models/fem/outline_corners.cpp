#include "solid_solver/models/fem/outline_corners.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <map>

namespace cosurge::fem {
namespace {

constexpr double sharp = 0.03;  // least share of the normals in any direction

}  // namespace

template <int dim>
std::vector<Vec<dim>> corners_of(const Shape<dim>& shape) {
  const auto before = [](const Vec<dim>& a, const Vec<dim>& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::map<Vec<dim>, Mat<dim>, decltype(before)> normals(before);
  for (const auto& facet : shape.facets()) {
    Vec<dim> normal;
    if constexpr (dim == 2)
      normal << facet[1][1] - facet[0][1], facet[0][0] - facet[1][0];
    else
      normal = (facet[1] - facet[0]).cross(facet[2] - facet[0]);
    if (normal.isZero(0)) continue;
    normal.normalize();
    for (const Vec<dim>& corner : facet)
      normals.try_emplace(corner, Mat<dim>::Zero()).first->second += normal * normal.transpose();
  }
  std::vector<Vec<dim>> corners;
  for (const auto& [corner, spread] : normals)
    if (Eigen::SelfAdjointEigenSolver<Mat<dim>>(spread).eigenvalues()[0] > sharp * spread.trace())
      corners.push_back(corner);
  return corners;
}

template std::vector<Vec<2>> corners_of<2>(const Shape<2>&);
template std::vector<Vec<3>> corners_of<3>(const Shape<3>&);

}  // namespace cosurge::fem
