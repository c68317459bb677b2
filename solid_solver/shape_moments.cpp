#include "solid_solver/shape_moments.hpp"

#include <Eigen/LU>
#include <cmath>

namespace cosurge {

template <int dim>
ShapeMoments<dim>::ShapeMoments(const Shape<dim>& shape)
    : centre(0.5 * (shape.bounds().min + shape.bounds().max)) {
  if (shape.is_box())
    sum_box(shape.bounds().max - shape.bounds().min);
  else
    sum_outline(shape.facets());
}

template <int dim>
void ShapeMoments<dim>::sum_box(const Vec<dim>& sides) {
  volume = sides.prod();
  surface = 2 * volume * sides.cwiseInverse().sum();
  second = (volume / 12 * sides.cwiseAbs2()).asDiagonal();
}

/// Simplices between the facets and one point, which cancel where they lie outside. With their corners v from
/// there, the integral of x (x) x over one is V (sum v (x) v + sum v (x) sum v) / ((dim + 1) (dim + 2)).
template <int dim>
void ShapeMoments<dim>::sum_outline(const std::vector<typename Shape<dim>::Facet>& facets) {
  volume = surface = 0;
  second.setZero();
  Vec<dim> first = Vec<dim>::Zero();
  for (const auto& facet : facets) {
    Mat<dim> corners;
    for (int k = 0; k < dim; ++k) corners.col(k) = facet[static_cast<std::size_t>(k)] - centre;
    const double part = corners.determinant() / (dim == 2 ? 2 : 6);
    const Vec<dim> sum = corners.rowwise().sum();
    volume += part;
    first += part / (dim + 1) * sum;
    second += part / ((dim + 1) * (dim + 2)) * (corners * corners.transpose() + sum * sum.transpose());
    surface += normal_of(facet).norm() / (dim - 1);
  }
  const Vec<dim> shift = first / volume;
  second -= volume * shift * shift.transpose();
  centre += shift;
  if (volume < 0) second = -second;
  volume = std::abs(volume);
}

template struct ShapeMoments<2>;
template struct ShapeMoments<3>;

}  // namespace cosurge
