#include <cmath>

#include "common/ordered_sum.hpp"
#include "fluid_solver/pressure/linear_solver.hpp"

namespace cosurge::fluid {
namespace {

template <typename Number>
double dot(const std::vector<double>& a, const std::vector<Number>& b) {
  return ordered_sum(static_cast<int>(a.size()),
                     [a = a.data(), b = b.data()](int i) { return a[i] * static_cast<double>(b[i]); });
}

/// r = b - A x; returns r . r.
double residual(const Matrix& A, const std::vector<double>& b, const std::vector<double>& x,
                std::vector<double>& r) {
  return ordered_block_sum(A.size(), [&, x = x.data()](int begin, int end) {
    double sum = 0;
    for (int i = begin; i < end; ++i) {
      r[i] = b[i] - A.times(i, x);
      sum += r[i] * r[i];
    }
    return sum;
  });
}

}  // namespace

SolveReport conjugate_gradient(const Matrix& A, const std::vector<double>& b, Preconditioner& M,
                               double tolerance, int max_iterations, std::vector<double>& x) {
  const int size = A.size();
  const double target = tolerance * std::sqrt(dot(b, b));
  if (target == 0) {
    std::fill(x.begin(), x.end(), 0.0);
    return {};
  }
  x.resize(Matrix::padded(size));
  std::vector<double> r(size);
  std::vector<float> z(size), q(size), p(Matrix::padded(size));  // x and r use the same rounded p and q = A p
  double norm = std::sqrt(residual(A, b, x, r));
  SolveReport report;
  double rho = 0;
  bool fresh = true;  // the search direction starts anew
  while (norm > target && report.iterations < max_iterations) {
    M.apply(r, z);
    const double rho_before = rho;
    rho = dot(r, z);
    const auto beta = fresh ? 0 : static_cast<float>(rho / rho_before);
    fresh = false;
#pragma omp parallel for simd schedule(static) if (size >= parallel_from)
    for (int i = 0; i < size; ++i) p[i] = z[i] + beta * p[i];
    const double alpha = rho / ordered_block_sum(size, [&](int begin, int end) {
                           double sum = 0;
                           for (int i = begin; i < end; ++i) {
                             q[i] = static_cast<float>(A.times(i, p.data()));
                             sum += static_cast<double>(p[i]) * static_cast<double>(q[i]);
                           }
                           return sum;
                         });
    if (!std::isfinite(alpha)) break;
    norm =
        std::sqrt(ordered_sum(size, [alpha, x = x.data(), r = r.data(), p = p.data(), q = q.data()](int i) {
          x[i] += alpha * static_cast<double>(p[i]);
          r[i] -= alpha * static_cast<double>(q[i]);
          return r[i] * r[i];
        }));
    ++report.iterations;
    if (norm > target && report.iterations < max_iterations) continue;
    norm = std::sqrt(residual(A, b, x, r));  // the recurrence may be inaccurate: use the true residual
    fresh = true;
  }
  x.resize(static_cast<std::size_t>(size));
  report.relative_residual = norm * tolerance / target;
  report.converged = norm <= target;
  return report;
}

}  // namespace cosurge::fluid
