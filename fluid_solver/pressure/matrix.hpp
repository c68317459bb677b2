// The matrix of the pressure equation.
#pragma once

#include <vector>

#include "fluid_solver/rows.hpp"

namespace cosurge::fluid {

/// Symmetric M-matrix: (A x)_i = diagonal_i x_i - sum_j weight_ij x_j with weight_ij = weight_ji > 0. Off-diagonals are
/// kept in single precision (both halves of a pair round to the same value); the diagonal in double.
struct Matrix {
  Rows rows;
  std::vector<std::int32_t> column;
  std::vector<float> weight;
  std::vector<double> diagonal;

  int size() const { return static_cast<int>(diagonal.size()); }

  /// Calls visit(column, weight) for the entries of row i, in ascending order.
  template <typename Visit>
  void each(int i, Visit&& visit) const {
    for (std::int64_t k = rows.begin(i); k < rows.end(i); ++k) visit(column[k], weight[k]);
  }

  template <typename Scalar>
  Scalar off_diagonal(int i, const Scalar* x) const {
    Scalar sum = 0;
    const std::int64_t first = rows.begin(i);
    const auto count = static_cast<int>(rows.end(i) - first);
    const float* const w = weight.data() + first;
    const std::int32_t* const j = column.data() + first;
#pragma omp simd reduction(+ : sum)
    for (int k = 0; k < count; ++k) sum += static_cast<Scalar>(w[k]) * x[j[k]];
    return sum;
  }
};

/// y = A x.
void multiply(const Matrix& A, const std::vector<double>& x, std::vector<double>& y);

}  // namespace cosurge::fluid
