// Interpolation from scattered nodes that is exact for affine motion.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "common/vec.hpp"

namespace cosurge {

/// Weight of a node at distance q = r / radius, the C2 function of Wendland (1995): (1 - q)^4 (1 + 4 q), 0
/// for q >= 1.
inline double wendland_weight(double q) {
  if (q >= 1) return 0;
  const double s = (1 - q) * (1 - q);
  return s * s * (1 + 4 * q);
}

/// Coefficients c_j of u(x) = sum_j c_j u_j by moving least squares with the basis (1, x - x_p) (Lancaster &
/// Salkauskas 1981; docs/method_solid.md, S17): sum_j c_j = 1 and sum_j c_j x_j = x, also outside the nodes'
/// hull. Empty where the nodes within the radius do not span the space.
template <int dim>
Eigen::VectorXd moving_least_squares(const Vec<dim>& x, const std::vector<Vec<dim>>& nodes, double radius) {
  using Basis = Eigen::Matrix<double, dim + 1, 1>;
  using Moments = Eigen::Matrix<double, dim + 1, dim + 1>;
  const auto basis = [&](const Vec<dim>& node) {
    Basis p;
    p << 1, (node - x) / radius;
    return p;
  };
  Moments moments = Moments::Zero();
  Eigen::VectorXd weights(nodes.size());
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    weights[j] = wendland_weight((nodes[j] - x).norm() / radius);
    const Basis p = basis(nodes[j]);
    moments += weights[j] * p * p.transpose();
  }
  const Eigen::FullPivLU<Moments> factors(moments);
  constexpr double degenerate = 1e-6;  // pivot ratio; collinear nodes: rounding, others 1e-3 or more
  const auto pivots = factors.matrixLU().diagonal().cwiseAbs();
  if (!(pivots.minCoeff() > degenerate * pivots.maxCoeff())) return {};
  const Basis first = factors.solve(Basis::Unit(0));
  Eigen::VectorXd coefficients(nodes.size());
  for (std::size_t j = 0; j < nodes.size(); ++j) coefficients[j] = weights[j] * basis(nodes[j]).dot(first);
  return coefficients;
}

}  // namespace cosurge
