// The divergence with the weights of the pressure equation, eq. (10b).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fluid_solver/operators.hpp"
#include "tests/support/pressure_tank.hpp"

namespace cosurge::fluid {
namespace {

using test::dt;
using test::g;
using test::l0;
using test::rho;
using test::single;
using test::Tank;

/// Divergence with the equation's weights where it is known, by unknown.
template <int dim>
std::vector<double> divergence_of(const Tank<dim>& tank, const Vec<dim>& kick = Vec<dim>::Zero()) {
  return tank.equation.divergence(tank.cloud.particles, tank.cloud.neighbors.grid(), kick);
}

template <int dim>
void expect_linear_divergence(Tank<dim> tank, int at_least) {
  auto& particles = tank.cloud.particles;
  for (auto& normal : particles.normal) normal.setZero();  // these walls move with the water
  const Mat<dim> A = test::some_matrix<dim>();
  for (int i = 0; i < particles.size(); ++i) particles.u[i] = A * particles.x[i] + Vec<dim>::Ones();
  int known = 0;
  for (const double divergence : divergence_of(tank)) {
    if (std::isnan(divergence)) continue;
    ++known;
    EXPECT_NEAR(divergence, A.trace(), 20 * single);
  }
  EXPECT_GT(known, at_least);
}

TEST(EquationDivergence, IsExactForLinearVelocitiesDownToTheCornersOfATank) {
  expect_linear_divergence(Tank<2>({}), 12 * 11);
  expect_linear_divergence(Tank<3>({.water = 0.10}), 12 * 12 * 5);
}

TEST(EquationDivergence, IsKnownWhereNoSurfaceAndNoBodyIsInSight) {
  const v1::Solid sunk_box = test::solid_of(test::box_of({0.05, 0.05}, {0.08, 0.08}));
  const Tank<2> tank({.solid = &sunk_box});
  const auto divergence = divergence_of(tank);
  const auto& particles = tank.cloud.particles;
  int known = 0;
  for (std::size_t k = 0; k < divergence.size(); ++k) {
    const int i = tank.equation.unknowns()[k];
    bool expected = particles.kind[i] == Kind::fluid;
    for (int j = 0; j < particles.size(); ++j) {
      const bool surface = has_pressure(particles.kind[j]) && particles.free_surface[j] != 0;
      const bool seen = (particles.x[j] - particles.x[i]).norm() < 4 * l0 * (1 - 1e-9);
      if (seen && (surface || of_body(particles.kind[j]))) expected = false;
    }
    EXPECT_EQ(!std::isnan(divergence[k]), expected) << particles.x[i].transpose();
    known += expected ? 1 : 0;
  }
  EXPECT_GT(known, 40);
}

TEST(EquationDivergence, OfABodysFacesDoesNotSeeTheBodysOwnStrain) {
  const v1::Solid sunk_box = test::solid_of(test::box_of({0.04, 0.05}, {0.08, 0.09}));
  Tank<2> tank({.solid = &sunk_box, .open_surface = true});
  auto& particles = tank.cloud.particles;
  const auto strain = [&](const Vec<2>& x) { return Vec<2>(10 * (x - Vec<2>(0.06, 0.07))); };
  int faces = 0;
  for (int i = 0; i < particles.size(); ++i)
    if (of_body(particles.kind[i])) particles.u[i] = strain(particles.x[i]);
  for (int i = 0; i < particles.size(); ++i) {
    // Water that moves with the point under test: only the body's other points move relative to it.
    if (particles.kind[i] != Kind::body_surface) continue;
    auto moved = particles;
    for (int j = 0; j < moved.size(); ++j)
      if (moved.kind[j] == Kind::fluid) moved.u[j] = particles.u[i];
    const auto divergence = tank.equation.divergence(moved, tank.cloud.neighbors.grid(), Vec<2>::Zero());
    const auto& unknowns = tank.equation.unknowns();
    const auto k =
        static_cast<std::size_t>(std::find(unknowns.begin(), unknowns.end(), i) - unknowns.begin());
    ASSERT_LT(k, unknowns.size());
    EXPECT_NEAR(divergence[k], 0, 1e-9);
    ++faces;
  }
  EXPECT_EQ(faces, 12);
}

TEST(EquationDivergence, ByBodiesIsZeroWhereNoneIsSeenAndTheSameWhereOneIs) {
  const v1::Solid sunk_box = test::solid_of(test::box_of({0.04, 0.05}, {0.08, 0.09}));
  Tank<2> tank({.solid = &sunk_box, .open_surface = true});
  auto& particles = tank.cloud.particles;
  for (int i = 0; i < particles.size(); ++i)
    particles.u[i] = of_body(particles.kind[i]) ? Vec<2>(0.3, -1) : Vec<2>(0, 0);
  const auto all = divergence_of(tank);
  const auto by_bodies =
      tank.equation.divergence_by_bodies(particles, particles.u, tank.cloud.neighbors.grid());
  double largest = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_NEAR(by_bodies[k], all[k], 1e-9);
    largest = std::max(largest, std::abs(all[k]));
  }
  EXPECT_GT(largest, 0.1 / l0);
}

TEST(EquationDivergence, IsTheRateAtWhichTheSmoothDensityThinsInAnyDisorder) {
  Tank<2> tank({.disorder = 0.2});
  auto& particles = tank.cloud.particles;
  for (auto& normal : particles.normal)
    normal.setZero();  // without normals: the density changes also by walls that move along their faces
  std::mt19937 random(3);
  std::normal_distribution<double> speed(0, 1);
  for (auto& u : particles.u) u = {speed(random), speed(random)};
  const auto divergence = divergence_of(tank);
  const auto deviation_after = [&](double t) {
    auto moved = particles;
    for (int i = 0; i < moved.size(); ++i) moved.x[i] += t * particles.u[i];
    tank.equation.assemble(moved, tank.cloud.neighbors.grid(), tank.areas, dt);
    return tank.equation.deviation();
  };
  constexpr double step = 1e-4 * l0;  // times speeds of one
  const auto before = deviation_after(-step), after = deviation_after(step);
  // 2 / (r_e^2 s0) by eq. (2b), d / (lambda0 n0) by eq. (10b).
  const ReferenceValues reference = reference_values<2>(4 * l0, l0);
  const double ratio = 2 / (16 * l0 * l0 * reference.smooth0) * reference.lambda0 * reference.n0 / 2;
  EXPECT_NEAR(ratio, 0.9707, 1e-4);
  int known = 0;
  for (std::size_t k = 0; k < divergence.size(); ++k) {
    if (std::isnan(divergence[k])) continue;
    ++known;
    EXPECT_NEAR((after[k] - before[k]) / (2 * step), -ratio * divergence[k], 2e-3 / l0);
  }
  EXPECT_GT(known, 80);
}

/// Water alone, with its free surface; the equation's divergence and the divergence of near neighbours.
struct Patch {
  test::Cloud<2> cloud = test::block<2>({48, 48}, l0);
  PoissonEquation<2> equation{
      {.spacing = l0, .re = 4 * l0, .density = rho, .compressibility = 1e-9, .gravity = {0, -g}}};
  ReferenceValues reference = reference_values<2>(2.1 * l0, l0);

  /// Root mean squares of the errors of both, eqs. (10b) and (10), where the former is known.
  template <typename Exact>
  std::pair<double, double> errors(Exact&& exact) {
    const Particles<2>& particles = cloud.particles;
    Neighbors<2> neighbors({Vec<2>::Constant(-0.1), Vec<2>::Constant(0.8)}, 2.1 * l0);
    neighbors.rebuild(cloud.particles);
    density_and_free_surface(cloud.particles, neighbors, reference.n0, {.beta = 0.97, .delta = 0.2 * l0});
    equation.assemble(particles, neighbors.grid(), {}, dt);
    const auto divergence = equation.divergence(particles, neighbors.grid(), Vec<2>::Zero());
    double wide = 0, near = 0;
    int known = 0;
    for (std::size_t k = 0; k < divergence.size(); ++k) {
      if (std::isnan(divergence[k])) continue;
      ++known;
      const int i = equation.unknowns()[k];
      const double d = near_divergence<2>(particles, particles.u, neighbors, i, reference.n0, Vec<2>::Zero());
      wide += std::pow(divergence[k] - exact(particles.x[i]), 2);
      near += std::pow(d - exact(particles.x[i]), 2);
    }
    EXPECT_GT(known, 30 * 30);
    return {std::sqrt(wide / known), std::sqrt(near / known)};
  }
};

// A collapsing column stretches its lattice along one axis and contracts it across. Eq. (10) gives a
// divergence for a motion that continues this, since near pairs have larger weights than far ones.
TEST(EquationDivergence, SeesThatAStretchedLatticeKeepsItsVolume) {
  constexpr double stretch = 1.2;
  Patch patch;
  Particles<2>& particles = patch.cloud.particles;
  for (int i = 0; i < particles.size(); ++i) {
    particles.x[i] = {stretch * particles.x[i][0], particles.x[i][1] / stretch};
    particles.u[i] = {particles.x[i][0], -particles.x[i][1]};
  }
  const auto [wide, near] = patch.errors([](const Vec<2>&) { return 0.0; });
  EXPECT_LT(wide, 0.02);  // for a rate of strain of 1
  EXPECT_GT(near, 0.1);
}

TEST(EquationDivergence, IsNearerInDisorderThanThatOfNearNeighbours) {
  constexpr double k = 6;  // a wave over two thirds of the patch
  Patch patch;
  patch.cloud = test::block<2>({48, 48}, l0, 0.1);
  Particles<2>& particles = patch.cloud.particles;
  for (int i = 0; i < particles.size(); ++i) particles.u[i] = (k * particles.x[i]).array().sin();
  const auto [wide, near] = patch.errors([&](const Vec<2>& x) { return k * (k * x).array().cos().sum(); });
  const double size = k;  // rms of the sum of two cosines
  EXPECT_LT(wide / size, 0.03);
  EXPECT_LT(wide, 0.4 * near);
}

TEST(EquationDivergence, IsZeroWhereWaterAndWallsHaveTheSameKick) {
  const Vec<2> kick(0, -0.01);
  for (const bool open_surface : {false, true}) {
    Tank<2> tank({.open_surface = open_surface});
    for (int i = 0; i < tank.cloud.particles.size(); ++i)
      tank.cloud.particles.u[i] = tank.cloud.particles.kind[i] == Kind::fluid ? kick : Vec<2>(0, 0);
    const double unknown = open_surface ? INFINITY : 0;  // with an open surface it is known everywhere
    double with = 0, without = 0;
    for (const double d : divergence_of(tank, kick))
      with = std::max(with, std::isnan(d) ? unknown : std::abs(d));
    for (const double d : divergence_of(tank))
      without = std::max(without, std::isnan(d) ? unknown : std::abs(d));
    EXPECT_EQ(with, 0);
    EXPECT_GT(without, 0.1 * 0.01 / l0);
    EXPECT_LT(without, INFINITY);
  }
}

}  // namespace
}  // namespace cosurge::fluid
