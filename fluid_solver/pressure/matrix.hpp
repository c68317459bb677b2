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
/// for each line of cells around it. A row is a list of blocks of `lanes` consecutive columns, zeros
/// included: half as many numbers again as a list of neighbours, but an index for a block only, no gathering,
/// and one loop whose end alone has to be guessed: several times faster. Weights are in single precision
/// (both halves of a pair round to the same value), the diagonal in double.
struct Matrix {
  static constexpr int lanes = 8;

  Rows rows;                        ///< of blocks
  std::vector<std::int32_t> first;  ///< column of the first weight of each block
  std::vector<float> weight;        ///< `lanes` a block, or as many as there are columns if those are fewer
  std::vector<double> diagonal;

  int size() const { return static_cast<int>(diagonal.size()); }

  /// sum_j weight_ij x_j.
  double off_diagonal(int i, const double* x) const {
    if (size() < lanes) return sum_few(i, x);
    Doubles even{};
    Doubles odd{};
    const std::int64_t end = rows.end(i);
    std::int64_t b = rows.begin(i);
    const float* w = weight.data() + b * lanes;
    for (; b + 2 <= end; b += 2, w += 2 * std::ptrdiff_t{lanes}) {
      even += product(w, x + first[b]);
      odd += product(w + lanes, x + first[b + 1]);
    }
    if (b < end) even += product(w, x + first[b]);
    const Doubles total = even + odd;
    return ((total[0] + total[4]) + (total[1] + total[5])) + ((total[2] + total[6]) + (total[3] + total[7]));
  }

  /// Calls visit(column, weight) for the entries of row i that are not zero, in ascending order.
  template <typename Visit>
  void each(int i, Visit&& visit) const {
    const int width = std::min(lanes, size());
    for (std::int64_t b = rows.begin(i); b < rows.end(i); ++b)
      for (int k = 0; k < width; ++k)
        if (weight[b * lanes + k] != 0) visit(first[b] + k, weight[b * lanes + k]);
  }

  /// Entries that are not zero.
  std::int64_t entries() const {
    std::int64_t count = 0;
    for (int i = 0; i < size(); ++i) each(i, [&](int, float) { ++count; });
    return count;
  }

 private:
  static Doubles product(const float* weights, const double* x) {
    Floats w;
    Doubles values;
    std::memcpy(&w, weights, sizeof w);
    std::memcpy(&values, x, sizeof values);
    return __builtin_convertvector(w, Doubles) * values;
  }

  double sum_few(int i, const double* x) const {
    double total = 0;
    each(i, [&](int column, float w) { total += static_cast<double>(w) * x[column]; });
    return total;
  }
};

/// y = A x.
void multiply(const Matrix& A, const std::vector<double>& x, std::vector<double>& y);

}  // namespace cosurge::fluid
