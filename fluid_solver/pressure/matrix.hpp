// The matrix of the pressure equation.
#pragma once

#include <vector>

#include "fluid_solver/pressure/lanes.hpp"
#include "fluid_solver/rows.hpp"
#include "fluid_solver/unfilled.hpp"

namespace cosurge::fluid {

/// Weights of a sparse matrix.
///
/// Unknowns are numbered by cell, so the neighbours of an unknown lie in a few ranges of consecutive columns,
/// one for each line of cells around it. A matrix row is a list of blocks of `lanes` consecutive columns,
/// zeros included. Compared with a list of single entries, it stores half as many numbers again, but one
/// index per block, needs no gather instructions, and has a single loop with one mispredicted branch; it is
/// several times faster.
///
/// Vectors are read in whole lanes: they have at least `lanes` numbers.
struct BlockRows {
  static constexpr int lanes = 8;
  static constexpr int ahead = 32;  ///< prefetch distance [blocks]

  Rows rows;                     ///< rows of blocks
  Unfilled<std::int32_t> first;  ///< column of the first weight of each block
  Unfilled<float> weight;        ///< `lanes` a block

  /// Numbers of a vector that `columns` are read from.
  static std::size_t padded(int columns) { return static_cast<std::size_t>(std::max(columns, lanes)); }

  /// First column of the block that holds this column; no block passes the last column.
  static int block_of(int column, int columns) { return std::max(0, std::min(column, columns - lanes)); }

  void make_room(std::int64_t blocks) {
    first.make_room(static_cast<std::size_t>(blocks));
    weight.make_room(static_cast<std::size_t>(blocks) * lanes);
  }

  /// Appends a weight to the row of blocks begin ... end; columns ascend.
  void append(int column, float w, int columns, std::int64_t begin, std::int64_t& end) {
    if (end == begin || column >= first[end - 1] + lanes) {
      first[end] = block_of(column, columns);
      std::fill_n(weight.data() + end * lanes, lanes, 0.0F);
      ++end;
    }
    weight[(end - 1) * lanes + column - first[end - 1]] = w;
  }

  /// Sum of term(weights, column) over the blocks of row i, by lane.
  template <typename Lanes, typename Term>
  auto sum(int i, Term&& term) const {
    Lanes even{};
    Lanes odd{};
    const std::int64_t end = rows.end(i);
    std::int64_t b = rows.begin(i);
    const float* w = weight.data() + b * lanes;
    for (; b + 2 <= end; b += 2, w += 2 * std::ptrdiff_t{lanes}) {
      __builtin_prefetch(w + std::ptrdiff_t{ahead} * lanes);
      even += term(load<Floats>(w), first[b]);
      odd += term(load<Floats>(w + lanes), first[b + 1]);
    }
    if (b < end) even += term(load<Floats>(w), first[b]);
    return sum_of_lanes<Lanes>(even + odd);
  }

  /// sum_j weight_ij x_j.
  float product(int i, const float* x) const {
    return sum<Floats>(i, [x](const Floats& w, int column) { return w * load<Floats>(x + column); });
  }

  /// Calls visit(column, weight) for the weights of row i that are not zero, in ascending order.
  template <typename Visit>
  void each(int i, Visit&& visit) const {
    for (std::int64_t b = rows.begin(i); b < rows.end(i); ++b)
      for (int k = 0; k < lanes; ++k)
        if (weight[b * lanes + k] != 0) visit(first[b] + k, weight[b * lanes + k]);
  }
};

/// Symmetric M-matrix: (A x)_i = own_i x_i + sum_j weight_ij (x_i - x_j) with weight_ij = weight_ji >= 0.
/// Weights are in single precision (both halves of a pair round to the same value), the rest in double.
struct Matrix : BlockRows {
  std::vector<double>
      own;  ///< diagonal part of each row alone: compressibility, neighbours at the free surface
  std::vector<double> diagonal;  ///< own_i + sum_j weight_ij

  int size() const { return static_cast<int>(diagonal.size()); }

  double times(int i, const double* x) const {
    const auto term = [x](const Floats& w, int column) { return doubles_of(w) * load<Doubles>(x + column); };
    return diagonal[i] * x[i] - sum<Doubles>(i, term);
  }

  /// The same for a vector in single precision. Differences of neighbours are exact, so that the rounding
  /// error is relative to the differences, not to the values.
  double times(int i, const float* x) const {
    const Floats here = x[i] - Floats{};
    const auto term = [x, here](const Floats& w, int column) {
      return w * (here - load<Floats>(x + column));
    };
    return own[i] * static_cast<double>(x[i]) + static_cast<double>(sum<Floats>(i, term));
  }

  /// Entries that are not zero.
  std::int64_t entries() const {
    std::int64_t count = 0;
    for (int i = 0; i < size(); ++i) each(i, [&](int, float) { ++count; });
    return count;
  }
};

}  // namespace cosurge::fluid
