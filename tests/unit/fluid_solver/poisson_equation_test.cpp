#include "fluid_solver/pressure/poisson_equation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fluid_solver/weight.hpp"
#include "tests/support/pressure_tank.hpp"

namespace cosurge::fluid {
namespace {

using test::box_of;
using test::dt;
using test::g;
using test::l0;
using test::rho;
using test::single;
using test::Tank;

/// The weight of unknown k towards unknown m; 0 if there is none.
float entry(const Matrix& A, int k, int m) {
  float found = 0;
  A.each(k, [&](int column, float weight) { found = column == m ? weight : found; });
  return found;
}

void expect_symmetric(const Matrix& A) {
  std::int64_t entries = 0;
  for (int k = 0; k < A.size(); ++k) {
    A.each(k, [&](int m, float weight) {
      EXPECT_EQ(weight, entry(A, m, k)) << k << ", " << m;
      ++entries;
    });
  }
  EXPECT_GT(entries, 10 * A.size());
}

const v1::Solid plate = test::solid_of(box_of({0.05, 0.0}, {0.08, 0.10}));
const v1::Solid sunk_box = test::solid_of(box_of({0.05, 0.05}, {0.08, 0.08}));

TEST(PoissonEquation, IsSymmetricToTheBit) {
  expect_symmetric(Tank<2>({}).equation.matrix());
  expect_symmetric(Tank<2>({.disorder = 0.3}).equation.matrix());
  expect_symmetric(Tank<2>({.disorder = 0.3, .solid = &plate}).equation.matrix());
  expect_symmetric(Tank<3>({.water = 0.08, .disorder = 0.3}).equation.matrix());
}

template <int dim>
void expect_row_sums(const Tank<dim>& tank, double compressibility) {
  const auto& particles = tank.cloud.particles;
  const Matrix& A = tank.equation.matrix();
  const ReferenceValues reference = reference_values<dim>(4 * l0, l0);
  const double stiffness = reference.lambda0 * reference.n0 / (2 * dim) * compressibility * rho / (dt * dt);
  int to_surface = 0;
  for (int k = 0; k < A.size(); ++k) {
    const int i = tank.equation.unknowns()[k];
    double surface = 0;
    for (int j = 0; j < particles.size(); ++j) {
      const double r = (particles.x[j] - particles.x[i]).norm();
      if (j != i && has_pressure(particles.kind[j]) && particles.free_surface[j] != 0 &&
          r < 4 * l0 * (1 - 1e-9))
        surface += weight(r, 4 * l0);
    }
    to_surface += surface > 0 ? 1 : 0;
    double sum = A.diagonal[k];
    A.each(k, [&](int, float weight_kj) { sum -= static_cast<double>(weight_kj); });
    EXPECT_NEAR(sum, surface + stiffness, single * A.diagonal[k]) << particles.x[i].transpose();
  }
  EXPECT_GT(to_surface, 10);
  EXPECT_LT(to_surface, A.size());
}

TEST(PoissonEquation, RowSumsAreTheCouplingToTheFreeSurfaceAndTheCompressibility) {
  expect_row_sums(Tank<2>({.disorder = 0.2}), 1e-20);
  expect_row_sums(Tank<2>({.disorder = 0.2, .compressibility = 1e-6}), 1e-6);
  expect_row_sums(Tank<3>({.water = 0.06, .compressibility = 1e-8}), 1e-8);
}

TEST(PoissonEquation, HasOneUnknownForEachParticleWithAPressureThatIsNotFreeSurface) {
  const Tank<2> tank({.disorder = 0.2, .solid = &plate});
  int expected = 0;
  const auto& particles = tank.cloud.particles;
  for (int i = 0; i < particles.size(); ++i)
    expected += has_pressure(particles.kind[i]) && particles.free_surface[i] == 0 ? 1 : 0;
  EXPECT_EQ(tank.equation.matrix().size(), expected);
  int in_cells = 0;
  const CellsOfUnknowns& cells = tank.equation.cells();
  for (std::size_t c = 0; c < cells.cell.size(); ++c) {
    for (int k = cells.first[c]; k < cells.first[c + 1]; ++k, ++in_cells) {
      const auto cell = tank.cloud.neighbors.grid().cell_of(particles.x[tank.equation.unknowns()[k]]);
      EXPECT_EQ((std::array{cell[0], cell[1], 0}), cells.cell[c]);
    }
  }
  EXPECT_EQ(in_cells, expected);
}

/// |b - A p| of the hydrostatic pressure, in units of rho g l0 times the diagonal, for the rows that `chosen`
/// selects.
template <int dim, typename Chosen>
double hydrostatic_residual(const Tank<dim>& tank, double depth, int& rows, Chosen&& chosen) {
  const auto& particles = tank.cloud.particles;
  const Matrix& A = tank.equation.matrix();
  std::vector<double> p, Ap(static_cast<std::size_t>(A.size()));
  for (const std::int32_t i : tank.equation.unknowns())
    p.push_back(rho * g * (depth - 0.5 * l0 - particles.x[i][dim - 1]));
  for (int k = 0; k < A.size(); ++k) Ap[k] = A.times(k, p.data());
  double worst = 0;
  rows = 0;
  for (int k = 0; k < A.size(); ++k) {
    if (!chosen(particles.x[tank.equation.unknowns()[k]])) continue;
    ++rows;
    worst = std::max(worst,
                     std::abs(Ap[k] - tank.equation.right_hand_side()[k]) / (A.diagonal[k] * rho * g * l0));
  }
  return worst;
}

// Full supports: floor, side walls and corners are exact, because dummies represent the missing water.
template <int dim>
void expect_hydrostatics(double depth) {
  const Tank<dim> tank({.water = depth});
  int rows = 0;
  const auto deep = [&](const Vec<dim>& x) { return x[dim - 1] < depth - 4 * l0; };
  EXPECT_LT(hydrostatic_residual(tank, depth, rows, deep),
            20 * single);  // times pressures of some 16 rho g l0
  EXPECT_GT(rows, 12 * 12);
}

TEST(PoissonEquation, HydrostaticPressureSolvesItDownToTheCornersOfATank) {
  expect_hydrostatics<2>(0.16);
  expect_hydrostatics<3>(0.10);
}

// Within its radius of the surface the support of the Laplacian ends at the surface layer, and nothing
// represents the missing part above it. The solution below is hydrostatic, for a surface that lies this much
// too high.
TEST(PoissonEquation, TheFreeSurfaceLiesLessThanASpacingTooHigh) {
  const Tank<2> tank({});
  const Matrix& A = tank.equation.matrix();
  const auto M = make_preconditioner(PressureSolution::Preconditioner::aggregation);
  M->set_up(A, tank.equation.cells());
  std::vector<double> p(static_cast<std::size_t>(A.size()), 0.0);
  ASSERT_TRUE(conjugate_gradient(A, tank.equation.right_hand_side(), *M, 1e-10, 2000, p).converged);
  for (int k = 0; k < A.size(); ++k) {
    const Vec<2>& x = tank.cloud.particles.x[tank.equation.unknowns()[k]];
    if (x[1] > 0.10) continue;
    const double too_high = p[k] / (rho * g) - (0.16 - x[1]);
    EXPECT_GT(too_high, 0.3 * l0) << x.transpose();
    EXPECT_LT(too_high, 1.0 * l0) << x.transpose();
  }
}

// The same around a body: what lies behind a wet face stands for the hydrostatic pressure, as dummies do.
TEST(PoissonEquation, HydrostaticPressureSolvesItAroundASunkBody) {
  const Tank<2> tank({.water = 0.16, .solid = &sunk_box});
  int rows = 0;
  const auto deep = [&](const Vec<2>& x) { return x[1] < 0.12; };
  EXPECT_LT(hydrostatic_residual(tank, 0.16, rows, deep), 20 * single);
}

/// Largest weight of a particle left of the plate towards one to the right of it, well below its tip and
/// above its foot, where the floor goes through.
float weight_through_plate(const Tank<2>& tank) {
  const auto& x = tank.cloud.particles.x;
  const auto& unknowns = tank.equation.unknowns();
  const Matrix& A = tank.equation.matrix();
  float largest = 0;
  int beside = 0;
  for (int k = 0; k < A.size(); ++k) {
    const Vec<2>& from = x[unknowns[k]];
    if (from[0] > 0.06 || from[1] < 0 || from[1] > 0.07) continue;
    A.each(k, [&](int column, float weight_to) {
      const Vec<2>& to = x[unknowns[column]];
      if (to[0] > 0.07 && to[1] > 0) largest = std::max(largest, weight_to);
      ++beside;
    });
  }
  EXPECT_GT(beside, 1000);
  return largest;
}

TEST(PoissonEquation, WaterDoesNotSeeThroughABodyOfThreeLayers) {
  EXPECT_EQ(weight_through_plate(Tank<2>({.solid = &plate})), 0);
  // Pressed onto both faces by 0.25 spacings, the weight between two fluid particles is w(3.5 l0); the
  // diagonal is about 30.
  EXPECT_LT(weight_through_plate(Tank<2>({.disorder = 0.25, .solid = &plate})), weight(3.5, 4.0) + 1e-6);
}

TEST(PoissonEquation, ASurfaceParticleFeelsTheWaterInFrontOfIt) {
  const Tank<2> tank({.solid = &plate});
  const int i = tank.cloud.nearest({0.055, 0.045});
  const auto& unknowns = tank.equation.unknowns();
  const auto k = static_cast<int>(std::find(unknowns.begin(), unknowns.end(), i) - unknowns.begin());
  ASSERT_EQ(tank.cloud.particles.kind[i], Kind::body_surface);
  for (const Vec<2>& x : {Vec<2>(0.045, 0.045), Vec<2>(0.035, 0.055), Vec<2>(0.055, 0.055)}) {
    const int j = tank.cloud.nearest(x);
    const auto m = static_cast<int>(std::find(unknowns.begin(), unknowns.end(), j) - unknowns.begin());
    EXPECT_NEAR(entry(tank.equation.matrix(), k, m), weight((x - tank.cloud.particles.x[i]).norm(), 4 * l0),
                single);
  }
}

TEST(PoissonEquation, SourcesEnterWithTheScaleOfTheLaplacian) {
  Tank<2> tank({});
  const auto before = tank.equation.right_hand_side();
  const auto size = static_cast<std::size_t>(tank.cloud.particles.size());
  tank.equation.set_source(std::vector<double>(size, 7.0));
  const ReferenceValues reference = reference_values<2>(4 * l0, l0);
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_NEAR(tank.equation.right_hand_side()[k] - before[k], -7.0 * reference.lambda0 * reference.n0 / 4,
                1e-12 * std::abs(before[k]) + 1e-15);
}

}  // namespace
}  // namespace cosurge::fluid
