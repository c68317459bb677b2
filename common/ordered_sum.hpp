// Sums that do not depend on the number of threads.
#pragma once

#include <algorithm>
#include <vector>

namespace cosurge {

inline constexpr int sum_block = 1024;      // terms summed by one thread in one go
inline constexpr int parallel_from = 4096;  // terms below which a second thread costs more than it helps

/// Sum of block(begin, end) over blocks of fixed size that cover 0 ... count, added in order.
template <typename Block>
double ordered_block_sum(int count, Block&& block) {
  const int blocks = (count + sum_block - 1) / sum_block;
  thread_local std::vector<double> partial;
  partial.resize(static_cast<std::size_t>(blocks));
  double* const partials = partial.data();
#pragma omp parallel for schedule(static) if (count >= parallel_from)
  for (int b = 0; b < blocks; ++b) partials[b] = block(b * sum_block, std::min(count, (b + 1) * sum_block));
  double sum = 0;
  for (int b = 0; b < blocks; ++b) sum += partials[b];
  return sum;
}

/// Sum of term(0) ... term(count - 1).
template <typename Term>
double ordered_sum(int count, Term&& term) {
  return ordered_block_sum(count, [&](int begin, int end) {
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = begin; i < end; ++i) sum += term(i);
    return sum;
  });
}

}  // namespace cosurge
