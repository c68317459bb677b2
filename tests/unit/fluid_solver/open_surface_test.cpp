// The free surface that missing water makes, eq. (11b).
#include "fluid_solver/pressure/open_surface.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/error.hpp"
#include "fluid_solver/weight.hpp"
#include "tests/support/pressure_tank.hpp"

namespace cosurge::fluid {
namespace {

using test::dt;
using test::g;
using test::l0;
using test::rho;
using test::Tank;

template <int dim>
OpenSurface surface(double re = 4 * l0) {
  return OpenSurface::on_lattice<dim>(re, l0, reference_values<dim>(re, l0).smooth0);
}

TEST(OpenSurface, TiesNothingWhereNoMoreIsLackingThanDisorderMakes) {
  for (const OpenSurface& law : {surface<2>(), surface<3>()}) {
    EXPECT_EQ(law.weight(-0.1), 0);
    EXPECT_EQ(law.weight(OpenSurface::tolerance), 0);
    EXPECT_GT(law.weight(1.01 * OpenSurface::tolerance), 0);
  }
}

TEST(OpenSurface, TiesTheStrongerTheMoreIsLacking) {
  for (const OpenSurface& law : {surface<2>(), surface<3>(), surface<2>(2.1 * l0), surface<3>(3.1 * l0)})
    for (double lack = 0.03; lack < 1; lack += 0.01)
      EXPECT_GT(law.weight(lack), law.weight(lack - 0.01)) << lack;
}

TEST(OpenSurface, RefusesARadiusThatSeesOneLayerOnly) { EXPECT_THROW(surface<2>(1.2 * l0), Error); }

/// Error of the pressure that the equation finds for water at rest, over rho g l0, by height in spacings.
template <int dim>
std::vector<double> errors_at_rest(const Tank<dim>& tank, double depth) {
  const Matrix& A = tank.equation.matrix();
  const auto preconditioner = make_preconditioner(PressureSolution::Preconditioner::aggregation);
  preconditioner->set_up(A, tank.equation.cells());
  std::vector<double> p(static_cast<std::size_t>(A.size()), 0.0);
  EXPECT_TRUE(
      conjugate_gradient(A, tank.equation.right_hand_side(), *preconditioner, 1e-8, 500, p).converged);
  std::vector<double> errors(static_cast<std::size_t>(std::lround(depth / l0)) + 1, 0.0);
  for (int k = 0; k < A.size(); ++k) {
    const double height = tank.cloud.particles.x[tank.equation.unknowns()[k]][dim - 1];
    if (height > depth) continue;
    const double error = (p[k] - rho * g * (depth - height)) / (rho * g * l0);
    double& worst = errors[static_cast<std::size_t>(std::max(0.0, height / l0 + 0.5))];
    if (std::abs(error) > std::abs(worst)) worst = error;
  }
  return errors;
}

// Rows of the two outermost layers are exact by the fit, sums of weights in single precision; the third
// lacks 1.8 %, where the fit gives a third of what it needs. That is what the floor feels: 0.2 of a spacing
// too much on the lattice, before the particles have settled.
TEST(OpenSurface, WaterAtRestHasItsSurfaceHalfASpacingAboveTheOutermostParticles) {
  for (const double error : errors_at_rest(Tank<2>({.water = 0.16, .open_surface = true}), 0.16))
    EXPECT_LT(std::abs(error), 0.4);  // 0.39 beside the side walls at the surface, 0.2 to 0.3 below
  EXPECT_GT(errors_at_rest(Tank<2>({}), 0.16).front(), 0.45);  // error with flags
}

TEST(OpenSurface, IsExactInTheTwoOutermostLayers) {
  const ReferenceValues reference = reference_values<2>(4 * l0, l0);
  std::array<double, 2> lack{}, needed{};
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j) {
      const double r = std::sqrt(static_cast<double>(i * i + j * j));
      if (r == 0 || r >= 4 * (1 - 1e-9)) continue;
      for (const int layer : {0, 1}) {
        const bool air = j > layer;
        if (air) lack[layer] += smooth_share(weight(r, 4.0)) / reference.smooth0;
        if (!air) needed[layer] += weight(r, 4.0) * (-j) / (layer + 0.5);  // P - P_i over P_i
      }
    }
  for (const int layer : {0, 1})
    EXPECT_NEAR(surface<2>().weight(lack[layer]), needed[layer], 1e-9 * needed[layer]);
}

TEST(OpenSurface, WallsWithoutWaterHaveNoPressureAndCountAsWalls) {
  const Tank<2> tank({.open_surface = true});
  const auto& particles = tank.cloud.particles;
  int dry = 0;
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::wall || particles.x[i][1] < 0.16 + 2.2 * l0) continue;
    ++dry;
    EXPECT_EQ(particles.free_surface[i], 1);
  }
  EXPECT_GT(dry, 2);
  for (const std::int32_t i : tank.equation.unknowns())
    if (particles.kind[i] == Kind::wall) {
      EXPECT_LT(particles.x[i][1], 0.16 + 2.2 * l0);
    }
}

}  // namespace
}  // namespace cosurge::fluid
