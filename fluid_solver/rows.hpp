// Rows of varying length, filled in parallel.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace cosurge::fluid {

/// Largest number of entries of a row, and of candidates for it.
constexpr int most_entries(int dim) { return dim == 2 ? 4096 : 32768; }

/// The row structure of neighbour lists and sparse matrices. The rows of a chunk are contiguous, and each
/// chunk has its own range of entries, so that chunks are filled independently and the result does not depend
/// on the number of threads.
class Rows {
 public:
  static constexpr int chunk = 256;

  /// Fills all rows: fill(row, place) writes the entries of `row` from `place` on and returns their number.
  /// `prepare(capacity)` allocates that many entries. A row may write up to `most` entries; `expected` is the
  /// average. If a chunk is too short for its rows, all rows are filled again with more room.
  template <typename Prepare, typename Fill>
  void fill(int rows, int expected, int most, Prepare&& prepare, Fill&& fill_row) {
    const int chunks = (rows + chunk - 1) / chunk;
    rows_ = rows;
    offset_.resize(static_cast<std::size_t>(rows) + static_cast<std::size_t>(chunks));
    share_ = std::max(share_, expected);
    for (bool full = true; full; share_ = full ? 2 * share_ : share_) {
      stretch_ = static_cast<std::int64_t>(chunk) * share_ + most;
      prepare(stretch_ * chunks);
      std::atomic<bool> overflow = false;
#pragma omp parallel for schedule(dynamic, 1)
      for (int c = 0; c < chunks; ++c) {
        const std::int64_t first = stretch_ * c;
        const std::int64_t last = stretch_ - most;
        std::int32_t* offset = offset_.data() + static_cast<std::ptrdiff_t>(c) * (chunk + 1);
        *offset = 0;
        for (int i = c * chunk; i < std::min(rows, (c + 1) * chunk) && *offset <= last; ++i, ++offset)
          offset[1] = *offset + static_cast<std::int32_t>(fill_row(i, first + *offset));
        if (*offset > last) overflow = true;
      }
      full = overflow;
    }
  }

  int rows() const { return rows_; }
  std::int64_t begin(int row) const { return stretch_ * (row / chunk) + offset_[row + row / chunk]; }
  std::int64_t end(int row) const { return stretch_ * (row / chunk) + offset_[row + row / chunk + 1]; }

  std::int64_t entries() const {
    std::int64_t sum = 0;
    for (int i = 0; i < rows(); ++i) sum += end(i) - begin(i);
    return sum;
  }

 private:
  int rows_ = 0;
  std::vector<std::int32_t> offset_;  // offset of each row in its chunk's range, and end of each chunk
  std::int64_t stretch_ = 0;          // entries allocated for a chunk
  int share_ = 0;                     // average number of entries allocated for a row
};

}  // namespace cosurge::fluid
