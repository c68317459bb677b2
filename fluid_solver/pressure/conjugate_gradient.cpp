#include <cmath>

#include "common/ordered_sum.hpp"
#include "fluid_solver/pressure/linear_solver.hpp"

namespace cosurge::fluid {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return ordered_sum(static_cast<int>(a.size()), [&](int i) { return a[i] * b[i]; });
}

/// r = b - A x.
void residual(const Matrix& A, const std::vector<double>& b, const std::vector<double>& x,
              std::vector<double>& r) {
  multiply(A, x, r);
  for (int i = 0; i < A.size(); ++i) r[i] = b[i] - r[i];
}

}  // namespace

void multiply(const Matrix& A, const std::vector<double>& x, std::vector<double>& y) {
#pragma omp parallel for schedule(static) if (A.size() >= parallel_from)
  for (int i = 0; i < A.size(); ++i) y[i] = A.diagonal[i] * x[i] - A.off_diagonal(i, x.data());
}

SolveReport conjugate_gradient(const Matrix& A, const std::vector<double>& b, Preconditioner& M,
                               double tolerance, int max_iterations, std::vector<double>& x) {
  const int size = A.size();
  const double target = tolerance * std::sqrt(dot(b, b));
  if (target == 0) {
    std::fill(x.begin(), x.end(), 0.0);
    return {};
  }
  std::vector<double> r(size), z(size), p(size), q(size);
  residual(A, b, x, r);
  double norm = std::sqrt(dot(r, r));
  SolveReport report;
  double rho = 0;
  bool fresh = true;  // the search direction starts anew
  while (norm > target && report.iterations < max_iterations) {
    M.apply(r, z);
    const double rho_before = rho;
    rho = dot(r, z);
    const double beta = fresh ? 0 : rho / rho_before;
    fresh = false;
#pragma omp parallel for simd schedule(static) if (size >= parallel_from)
    for (int i = 0; i < size; ++i) p[i] = z[i] + beta * p[i];
    const double alpha = rho / ordered_block_sum(size, [&](int begin, int end) {
                           double sum = 0;
                           for (int i = begin; i < end; ++i) {
                             q[i] = A.diagonal[i] * p[i] - A.off_diagonal(i, p.data());
                             sum += p[i] * q[i];
                           }
                           return sum;
                         });
    if (!std::isfinite(alpha)) break;
    norm = std::sqrt(ordered_sum(size, [&](int i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
      return r[i] * r[i];
    }));
    ++report.iterations;
    if (norm > target) continue;
    residual(A, b, x, r);  // the recurrence may have drifted: go on from the true residual
    norm = std::sqrt(dot(r, r));
    fresh = true;
  }
  report.relative_residual = norm * tolerance / target;
  report.converged = norm <= target;
  return report;
}

}  // namespace cosurge::fluid
