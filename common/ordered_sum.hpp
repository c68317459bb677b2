// Sums and maxima that do not depend on the number of threads.
#pragma once

#include <algorithm>
#include <vector>

namespace cosurge {

inline constexpr int sum_block = 1024;      // terms summed by one thread in one go
inline constexpr int parallel_from = 4096;  // terms below which a second thread costs more than it helps

/// Sum of term(0) ... term(count - 1), in blocks of fixed size whose sums are added in order.
template <typename Term>
double ordered_sum(int count, Term&& term) {
  const int blocks = (count + sum_block - 1) / sum_block;
  thread_local std::vector<double> partial;
  partial.resize(static_cast<std::size_t>(blocks));
  double* const partials = partial.data();
#pragma omp parallel for schedule(static) if (count >= parallel_from)
  for (int b = 0; b < blocks; ++b) {
    double sum = 0;
    const int end = std::min(count, (b + 1) * sum_block);
#pragma omp simd reduction(+ : sum)
    for (int i = b * sum_block; i < end; ++i) sum += term(i);
    partials[b] = sum;
  }
  double sum = 0;
  for (int b = 0; b < blocks; ++b) sum += partials[b];
  return sum;
}

}  // namespace cosurge
