// The Lagrange element of second order: 9 nodes in the plane, 27 in space.
#pragma once

#include <array>
#include <cmath>

#include "common/vec.hpp"

namespace cosurge::fem {

/// Products of quadratic polynomials along each axis, on the reference cell [-1, 1]^dim. Node a has the
/// coordinates -1, 0 or 1, the first axis fastest.
template <int dim>
struct QuadraticElement {
  static constexpr int nodes = dim == 2 ? 9 : 27;
  using Values = Eigen::Matrix<double, nodes, 1>;
  using Gradients = Eigen::Matrix<double, nodes, dim>;  ///< row a: d N_a / d xi

  /// A point and weight of Gauss's rule.
  struct Sample {
    Vec<dim> xi;
    double weight;
  };

  /// Coordinates of node a along each axis, counted 0, 1, 2.
  static Eigen::Matrix<int, dim, 1> place(int a) {
    Eigen::Matrix<int, dim, 1> digits;
    for (int k = 0; k < dim; ++k, a /= 3) digits[k] = a % 3;
    return digits;
  }

  static Values values(const Vec<dim>& xi) {
    Values N;
    for (int a = 0; a < nodes; ++a) {
      N[a] = 1;
      for (int k = 0; k < dim; ++k) N[a] *= along(xi[k])[place(a)[k]];
    }
    return N;
  }

  static Gradients gradients(const Vec<dim>& xi) {
    Gradients G;
    for (int a = 0; a < nodes; ++a) {
      for (int m = 0; m < dim; ++m) {
        G(a, m) = 1;
        for (int k = 0; k < dim; ++k) G(a, m) *= (k == m ? slope(xi[k]) : along(xi[k]))[place(a)[k]];
      }
    }
    return G;
  }

  /// Three points along each axis: exact for polynomials of fifth order, the mass matrix among them. The
  /// weights add up to 2^dim.
  static std::array<Sample, nodes> gauss() {
    const std::array<double, 3> at = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
    const std::array<double, 3> weight = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    std::array<Sample, nodes> samples;
    for (int a = 0; a < nodes; ++a) {
      samples[a].weight = 1;
      for (int k = 0; k < dim; ++k) {
        samples[a].xi[k] = at[place(a)[k]];
        samples[a].weight *= weight[place(a)[k]];
      }
    }
    return samples;
  }

 private:
  static std::array<double, 3> along(double xi) {
    return {0.5 * xi * (xi - 1), (1 - xi) * (1 + xi), 0.5 * xi * (xi + 1)};
  }
  static std::array<double, 3> slope(double xi) { return {xi - 0.5, -2 * xi, xi + 0.5}; }
};

}  // namespace cosurge::fem
