// Cost of a pressure solve: build/release/bin/pressure_solve [--benchmark_filter=...]
//
// A disordered column of water with the compressibility of water, 1e4 to 6.8e5 unknowns, cold start, to 1e-3;
// one thread by OMP_NUM_THREADS=1. `as_public_codes_do` builds a list of triplets, sorts them into Eigen's
// sparse matrix and calls Eigen's conjugate gradients, all afresh in every step, to the same residual and to
// Eigen's default.
#include <benchmark/benchmark.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "tests/support/column.hpp"

namespace {

using cosurge::fluid::conjugate_gradient;
using cosurge::fluid::Matrix;
using cosurge::fluid::test::Column;
using Choice = cosurge::fluid::PressureSolution::Preconditioner;

constexpr double water = 4.5e-10;  // compressibility [1/Pa]
constexpr double tolerance = 1e-3;

/// The column of a size, made once.
Column& column(int width) {
  static std::map<int, std::unique_ptr<Column>> columns;
  auto& one = columns[width];
  if (!one) one = std::make_unique<Column>(width, water);
  return *one;
}

double bytes(const Matrix& A) {
  double blocks = 0;
  for (int i = 0; i < A.size(); ++i) blocks += static_cast<double>(A.rows.end(i) - A.rows.begin(i));
  const double a_block = sizeof(std::int32_t) + Matrix::lanes * sizeof(float);
  // x, y; what is the row's own; begin and end
  const double a_row = 2 * sizeof(float) + sizeof(double) + 2 * sizeof(std::int64_t);
  return blocks * a_block + A.size() * a_row;
}

void triad(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(bytes(column(static_cast<int>(state.range(0))).A()) / 24);
  std::vector<double> a(size, 1), b(size, 2), c(size, 3);
  for (auto _ : state) {
    for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 0.5 * c[i];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] =
      benchmark::Counter(24.0 * static_cast<double>(size), benchmark::Counter::kIsIterationInvariantRate);
}

void product(benchmark::State& state) {
  const Matrix& A = column(static_cast<int>(state.range(0))).A();
  std::vector<float> x(static_cast<std::size_t>(A.size()), 1.5F);
  std::vector<float> y(x.size());
  for (auto _ : state) {
    for (int i = 0; i < A.size(); ++i) y[i] = static_cast<float>(A.times(i, x.data()));
    benchmark::DoNotOptimize(y.data());
  }
  state.counters["bytes"] = benchmark::Counter(bytes(A), benchmark::Counter::kIsIterationInvariantRate);
}

void assembly(benchmark::State& state) {
  Column& c = column(static_cast<int>(state.range(0)));
  for (auto _ : state) c.assemble();
  state.counters["unknowns"] = c.A().size();
}

void set_up(benchmark::State& state) {
  const Column& c = column(static_cast<int>(state.range(0)));
  const auto M = c.preconditioner(Choice::aggregation);
  for (auto _ : state) M->set_up(c.A(), c.equation.cells());
}

template <Choice word>
void solve(benchmark::State& state) {
  const Column& c = column(static_cast<int>(state.range(0)));
  const auto M = c.preconditioner(word);
  std::vector<double> x(c.b().size());
  int iterations = 0;
  for (auto _ : state) {
    std::fill(x.begin(), x.end(), 0.0);
    iterations = conjugate_gradient(c.A(), c.b(), *M, tolerance, 10000, x).iterations;
  }
  state.counters["iterations"] = iterations;
}

void as_public_codes_do(benchmark::State& state, double to) {
  const Column& c = column(static_cast<int>(state.range(0)));
  const Matrix& A = c.A();
  const Eigen::Map<const Eigen::VectorXd> b(c.b().data(), A.size());
  Eigen::Index iterations = 0;
  for (auto _ : state) {
    std::vector<Eigen::Triplet<double>> triplets;
    for (int i = 0; i < A.size(); ++i) {
      triplets.emplace_back(i, i, A.diagonal[i]);
      A.each(i, [&](int j, float w) { triplets.emplace_back(i, j, -static_cast<double>(w)); });
    }
    Eigen::SparseMatrix<double> matrix(A.size(), A.size());
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
    if (to > 0) solver.setTolerance(to);
    solver.compute(matrix);
    const Eigen::VectorXd x = solver.solve(b);
    benchmark::DoNotOptimize(x.data());
    iterations = solver.iterations();
  }
  state.counters["iterations"] = static_cast<double>(iterations);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(72)->Arg(155)->Arg(292)->Arg(584)->Unit(benchmark::kMillisecond);
}

BENCHMARK(triad)->Apply(sizes);
BENCHMARK(product)->Arg(16)->Apply(sizes);  // the smallest lies in the first caches
BENCHMARK(assembly)->Apply(sizes);
BENCHMARK(set_up)->Apply(sizes);
BENCHMARK(solve<Choice::aggregation>)->Apply(sizes);
BENCHMARK(solve<Choice::jacobi>)->Apply(sizes);
BENCHMARK_CAPTURE(as_public_codes_do, same_residual, tolerance)
    ->Arg(155)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(as_public_codes_do, eigens_default, 0.0)
    ->Arg(155)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
