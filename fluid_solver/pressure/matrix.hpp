// The matrix of the pressure equation.
#pragma once

#include <cstring>
#include <vector>

#include "fluid_solver/rows.hpp"

namespace cosurge::fluid {

/// Eight numbers that are computed at once.
using Floats = float __attribute__((vector_size(8 * sizeof(float))));
using Doubles = double __attribute__((vector_size(8 * sizeof(double))));

/// Symmetric M-matrix: (A x)_i = diagonal_i x_i - sum_j weight_ij x_j with weight_ij = weight_ji >= 0.
///
/// Unknowns are numbered by cell, so the neighbours of a row lie in a few runs of consecutive columns, one
/// for each line of cells around it. A run is kept whole, zeros included: twice the numbers of a list of
/// neighbours, but no column indices and no gathering, which is several times faster. Weights are in single
/// precision (both halves of a pair round to the same value), the diagonal in double.
struct Matrix {
  static constexpr int lanes = 8;

  /// Consecutive columns from `first` on; `length` is a multiple of `lanes` unless the matrix is smaller than
  /// that.
  struct Run {
    std::int32_t first;
    std::int32_t length;
  };

  Rows rows;  ///< of weights
  std::vector<float> weight;
  int runs_per_row = 0;  ///< places in `run` for each row
  std::vector<Run> run;  ///< those in use come first, then one of length 0 where there is room
  std::vector<double> diagonal;

  int size() const { return static_cast<int>(diagonal.size()); }

  /// sum_j weight_ij x_j.
  float off_diagonal(int i, const float* x) const { return sum<Floats>(i, x); }
  double off_diagonal(int i, const double* x) const { return sum<Doubles>(i, x); }

  /// Calls visit(run, weights) for each run of row i.
  template <typename Visit>
  void each_run(int i, Visit&& visit) const {
    const float* w = weight.data() + rows.begin(i);
    const Run* r = run.data() + static_cast<std::ptrdiff_t>(i) * runs_per_row;
    for (const Run* last = r + runs_per_row; r != last && r->length > 0; w += r->length, ++r) visit(*r, w);
  }

  /// Calls visit(column, weight) for the entries of row i that are not zero, in ascending order.
  template <typename Visit>
  void each(int i, Visit&& visit) const {
    each_run(i, [&](const Run& r, const float* w) {
      for (int k = 0; k < r.length; ++k)
        if (w[k] != 0) visit(r.first + k, w[k]);
    });
  }

  /// Entries that are not zero.
  std::int64_t entries() const {
    std::int64_t count = 0;
    for (int i = 0; i < size(); ++i) each(i, [&](int, float) { ++count; });
    return count;
  }

 private:
  template <typename Lanes, typename Scalar>
  Scalar sum(int i, const Scalar* x) const {
    Lanes total{};
    Scalar rest = 0;
    each_run(i, [&](const Run& r, const float* w) {
      const Scalar* const at = x + r.first;
      int k = 0;
      for (; k + lanes <= r.length; k += lanes) {
        Floats weights;
        Lanes values;
        std::memcpy(&weights, w + k, sizeof weights);
        std::memcpy(&values, at + k, sizeof values);
        total += __builtin_convertvector(weights, Lanes) * values;
      }
      for (; k < r.length; ++k) rest += static_cast<Scalar>(w[k]) * at[k];
    });
    return ((total[0] + total[4]) + (total[1] + total[5])) + ((total[2] + total[6]) + (total[3] + total[7])) +
           rest;
  }
};

/// y = A x.
void multiply(const Matrix& A, const std::vector<double>& x, std::vector<double>& y);

}  // namespace cosurge::fluid
