#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "common/threads.hpp"
#include "tests/support/column.hpp"

namespace cosurge::fluid {
namespace {

using Vector = std::vector<double>;
using Choice = PressureSolution::Preconditioner;

std::string name_of(Choice choice) { return choice == Choice::jacobi ? "jacobi" : "aggregation"; }

using test::Column;

SolveReport solve(const Column& column, Choice word, double tolerance, int max_iterations, Vector& x) {
  return conjugate_gradient(column.A(), column.b(), *column.preconditioner(word), tolerance, max_iterations,
                            x);
}

double dot(const Vector& a, const Vector& b) {
  long double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<long double>(a[i]) * b[i];
  return static_cast<double>(sum);
}

/// ||b - A x|| / ||b||, from the entries and nothing of the solver.
double true_residual(const Matrix& A, const Vector& b, const Vector& x) {
  Vector r(b);
  for (int i = 0; i < A.size(); ++i) {
    r[i] -= A.diagonal[i] * x[i];
    A.each(i, [&](int j, float weight) { r[i] += static_cast<double>(weight) * x[j]; });
  }
  return std::sqrt(dot(r, r) / dot(b, b));
}

class ConjugateGradient : public ::testing::TestWithParam<Choice> {};
INSTANTIATE_TEST_SUITE_P(Preconditioners, ConjugateGradient,
                         ::testing::Values(Choice::aggregation, Choice::jacobi),
                         [](const auto& word) { return name_of(word.param); });

TEST_P(ConjugateGradient, ReachesTenDigitsAndReportsTheTrueResidual) {
  const Column column(36);
  for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
    Vector x(column.b().size(), 0.0);
    const SolveReport report = solve(column, GetParam(), tolerance, 2000, x);
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.iterations, 1);
    EXPECT_LE(report.relative_residual, tolerance);
    // Rounding of b - A x: 45 terms of 1e-16 each, with entries of x that are some 1e3 times those of b.
    EXPECT_NEAR(report.relative_residual, true_residual(column.A(), column.b(), x), 1e-12);
  }
}

TEST_P(ConjugateGradient, SaysSoWhenItDoesNotConverge) {
  const Column column(36);
  Vector x(column.b().size(), 0.0);
  const SolveReport report = solve(column, GetParam(), 1e-10, 3, x);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_GT(report.relative_residual, 1e-10);
  EXPECT_NEAR(report.relative_residual, true_residual(column.A(), column.b(), x), 1e-12);
}

TEST_P(ConjugateGradient, NotANumberIsNoSolution) {
  const Column column(20);
  Vector b = column.b();
  b[7] = std::numeric_limits<double>::quiet_NaN();
  Vector x(b.size(), 0.0);
  EXPECT_FALSE(conjugate_gradient(column.A(), b, *column.preconditioner(GetParam()), 1e-4, 100, x).converged);
}

TEST_P(ConjugateGradient, StartsFromWhatItIsGiven) {
  const Column column(36);
  Vector x(column.b().size(), 0.0);
  ASSERT_TRUE(solve(column, GetParam(), 1e-8, 2000, x).converged);
  const Vector solved = x;
  EXPECT_EQ(solve(column, GetParam(), 1e-7, 2000, x).iterations, 0);
  EXPECT_EQ(x, solved);
}

TEST_P(ConjugateGradient, NoSourceMeansNoPressureWhateverTheStart) {
  const Column column(20);
  const Vector b(column.b().size(), 0.0);
  Vector x(b.size(), 3.0);
  EXPECT_TRUE(conjugate_gradient(column.A(), b, *column.preconditioner(GetParam()), 1e-4, 100, x).converged);
  EXPECT_EQ(x, b);
}

TEST_P(ConjugateGradient, GivesTheSameBitsForAnyNumberOfThreads) {
  const Column column(72);  // large enough for every loop to run in parallel
  Vector first;
  for (const int threads : {1, 2, 4}) {
    set_threads(threads);
    Vector x(column.b().size(), 0.0);
    ASSERT_TRUE(solve(column, GetParam(), 1e-6, 2000, x).converged);
    if (first.empty()) first = x;
    EXPECT_EQ(x, first) << threads;
  }
}

/// M x.
Vector applied(Preconditioner& M, const Vector& x) {
  std::vector<float> z(x.size());
  M.apply(x, z);
  return {z.begin(), z.end()};
}

TEST_P(ConjugateGradient, ThePreconditionerIsSymmetricAndPositive) {
  const Column column(48);
  const auto M = column.preconditioner(GetParam());
  std::mt19937 random(2);
  std::normal_distribution<double> noise;
  Vector x(column.b().size()), y(column.b().size());
  for (int trial = 0; trial < 5; ++trial) {
    for (double& v : x) v = noise(random);
    for (double& v : y) v = noise(random) + 1;  // smooth and rough parts
    const Vector Mx = applied(*M, x);
    const Vector My = applied(*M, y);
    EXPECT_GT(dot(x, Mx), 0);
    EXPECT_GT(dot(y, My), 0);
    const double size = std::sqrt(dot(x, Mx) * dot(y, My));
    // Single precision, and sums over a hierarchy of some 4600 unknowns.
    EXPECT_NEAR(dot(x, My) / size, dot(y, Mx) / size, 2e-5);
  }
}

TEST(Iterations, HardlyGrowWithAggregationAndDoubleWithTheResolutionWithout) {
  std::map<Choice, std::map<int, int>> iterations;
  for (const int width : {36, 72, 144}) {  // 2 556, 10 296, 41 328 unknowns
    const Column column(width);
    for (const Choice word : {Choice::aggregation, Choice::jacobi}) {
      Vector x(column.b().size(), 0.0);
      const SolveReport report = solve(column, word, 1e-3, 5000, x);
      EXPECT_TRUE(report.converged);
      iterations[word][width] = report.iterations;
      RecordProperty(name_of(word) + "_" + std::to_string(width), report.iterations);
    }
  }
  const auto growth = [&](Choice word) {
    return static_cast<double>(iterations[word][144]) / iterations[word][36];
  };
  EXPECT_LT(growth(Choice::aggregation), 2);
  EXPECT_GT(growth(Choice::jacobi), 3);  // the condition goes with 1 / l0^2: 4 in theory
  EXPECT_LT(iterations[Choice::aggregation][144], 20);
}

// Spray: particles without a surface hang on the compressibility alone.
TEST(Iterations, GroupsWithoutAFreeSurfaceAreSolvedToo) {
  auto cloud = test::block<2>({40, 40}, Column::l0, 0.2);
  auto& particles = cloud.particles;
  for (int i = 0; i < particles.size(); ++i) particles.x[i][0] += particles.x[i][0] > 0.08 ? 0.02 : 0;
  Neighbors<2> neighbors({{-0.02, -0.02}, {0.3, 0.3}}, 2.1 * Column::l0);
  neighbors.rebuild(particles);
  for (const Choice word : {Choice::aggregation, Choice::jacobi}) {
    PoissonEquation<2> equation({.spacing = Column::l0,
                                 .re = 4 * Column::l0,
                                 .density = 1000,
                                 .compressibility = 1e-9,
                                 .gravity = {0, 0}});
    equation.assemble(particles, neighbors.grid(), {}, 1e-4);
    equation.set_source(Vector(particles.x.size(), 1.0));
    const auto M = make_preconditioner(word);
    M->set_up(equation.matrix(), equation.cells());
    Vector x(equation.right_hand_side().size(), 0.0);
    EXPECT_TRUE(
        conjugate_gradient(equation.matrix(), equation.right_hand_side(), *M, 1e-4, 2000, x).converged);
    // Uniform: alpha rho / dt^2 P = -S.
    EXPECT_NEAR(x[0] / (-1.0 / (1e-9 * 1000 / 1e-8)), 1, 1e-2);
  }
}

}  // namespace
}  // namespace cosurge::fluid
