// Solves the same pressure equation as pressure_solve with hypre's conjugate gradients and BoomerAMG. Built
// if Debian's libhypre-dev is installed: build/release/bin/hypre_solve.
#include <HYPRE.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <benchmark/benchmark.h>
#include <mpi.h>

#include "tests/support/column.hpp"

namespace {

using cosurge::fluid::Matrix;
using cosurge::fluid::test::Column;

constexpr double water = 4.5e-10;  // compressibility [1/Pa]
constexpr double tolerance = 1e-3;

HYPRE_IJVector vector_of(const std::vector<double>& values) {
  HYPRE_IJVector v = nullptr;
  HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, static_cast<HYPRE_BigInt>(values.size()) - 1, &v);
  HYPRE_IJVectorSetObjectType(v, HYPRE_PARCSR);
  HYPRE_IJVectorInitialize(v);
  HYPRE_IJVectorSetValues(v, static_cast<HYPRE_Int>(values.size()), nullptr, values.data());
  HYPRE_IJVectorAssemble(v);
  return v;
}

HYPRE_IJMatrix matrix_of(const Matrix& A) {
  HYPRE_IJMatrix matrix = nullptr;
  HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, A.size() - 1, 0, A.size() - 1, &matrix);
  HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
  HYPRE_IJMatrixInitialize(matrix);
  std::vector<HYPRE_BigInt> columns;
  std::vector<double> values;
  for (HYPRE_BigInt i = 0; i < A.size(); ++i) {
    columns = {i};
    values = {A.diagonal[static_cast<std::size_t>(i)]};
    A.each(static_cast<int>(i), [&](int j, float w) {
      columns.push_back(j);
      values.push_back(-static_cast<double>(w));
    });
    auto count = static_cast<HYPRE_Int>(columns.size());
    HYPRE_IJMatrixSetValues(matrix, 1, &count, &i, columns.data(), values.data());
  }
  HYPRE_IJMatrixAssemble(matrix);
  return matrix;
}

template <typename Parallel, typename Owner, typename Get>
Parallel parallel(Owner owner, Get get) {
  void* object = nullptr;
  get(owner, &object);
  return static_cast<Parallel>(object);
}

/// Set-up and solution; the matrix is handed over before.
void boomer_amg(benchmark::State& state) {
  const Column column(static_cast<int>(state.range(0)), water);
  HYPRE_IJMatrix A = matrix_of(column.A());
  HYPRE_IJVector b = vector_of(column.b());
  HYPRE_IJVector x = vector_of(std::vector<double>(column.b().size(), 0.0));
  auto A_csr = parallel<HYPRE_ParCSRMatrix>(A, HYPRE_IJMatrixGetObject);
  auto b_par = parallel<HYPRE_ParVector>(b, HYPRE_IJVectorGetObject);
  auto x_par = parallel<HYPRE_ParVector>(x, HYPRE_IJVectorGetObject);
  HYPRE_Int iterations = 0;
  for (auto _ : state) {
    HYPRE_ParVectorSetConstantValues(x_par, 0.0);
    HYPRE_Solver amg = nullptr;
    HYPRE_BoomerAMGCreate(&amg);
    HYPRE_BoomerAMGSetMaxIter(amg, 1);
    HYPRE_BoomerAMGSetTol(amg, 0.0);
    HYPRE_BoomerAMGSetRelaxType(amg, 6);  // symmetric Gauss-Seidel, as conjugate gradients need it
    HYPRE_Solver cg = nullptr;
    HYPRE_ParCSRPCGCreate(MPI_COMM_SELF, &cg);
    HYPRE_PCGSetTol(cg, tolerance);
    HYPRE_PCGSetTwoNorm(cg, 1);
    HYPRE_PCGSetMaxIter(cg, 1000);
    HYPRE_PCGSetPrecond(cg, reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSolve),
                        reinterpret_cast<HYPRE_PtrToSolverFcn>(HYPRE_BoomerAMGSetup), amg);
    HYPRE_ParCSRPCGSetup(cg, A_csr, b_par, x_par);
    HYPRE_ParCSRPCGSolve(cg, A_csr, b_par, x_par);
    HYPRE_PCGGetNumIterations(cg, &iterations);
    HYPRE_ParCSRPCGDestroy(cg);
    HYPRE_BoomerAMGDestroy(amg);
  }
  state.counters["iterations"] = iterations;
  HYPRE_IJMatrixDestroy(A);
  HYPRE_IJVectorDestroy(b);
  HYPRE_IJVectorDestroy(x);
}

BENCHMARK(boomer_amg)->Arg(72)->Arg(155)->Arg(292)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  HYPRE_Init();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  HYPRE_Finalize();
  MPI_Finalize();
}
