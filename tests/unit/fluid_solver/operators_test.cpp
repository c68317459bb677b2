#include "fluid_solver/operators.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "fluid_solver/reference_values.hpp"
#include "fluid_solver/viscosity.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using test::block;
using test::Cloud;
using test::some_matrix;

constexpr double l0 = 0.01;
constexpr double rounding =
    1e-10;  // sums of up to 32 terms u / l0^2, u of order one: 1e-16 / 1e-4, and cancellation

/// Laplacian of the velocity in water without walls.
template <int dim>
Vec<dim> laplacian(const Cloud<dim>& cloud, int i, const ReferenceValues& reference) {
  return velocity_laplacian(cloud.particles, cloud.neighbors, i, {}, Vec<dim>(Vec<dim>::Zero()), reference.n0,
                            reference.lambda0);
}

template <typename T>
class Operators : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Operators, Dimensions);

template <int dim>
struct Lattice {
  Cloud<dim> cloud = block<dim>(test::Counts<dim>::Constant(7), l0);
  int i = cloud.nearest(Vec<dim>::Constant(3.5 * l0));  // two layers away from every face
  ReferenceValues reference = reference_values<dim>(2.1 * l0, l0);
};

TYPED_TEST(Operators, AreExactForConstantAndLinearFieldsInsideALattice) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  const Mat<dim> A = some_matrix<dim>();
  const Vec<dim> slope = A.col(0) * 1e3;
  for (int j = 0; j < particles.size(); ++j) {
    particles.u[j] = A * particles.x[j] + Vec<dim>::Ones();
    particles.p[j] = 5 + slope.dot(particles.x[j]);
  }
  const double n0 = l.reference.n0;
  EXPECT_NEAR(near_divergence<dim>(particles, particles.u, neighbors, l.i, n0, Vec<dim>::Zero()), A.trace(),
              rounding);
  EXPECT_LT(laplacian(l.cloud, l.i, l.reference).norm(), rounding);
  EXPECT_LT((gradient_p_min(particles, neighbors, l.i, n0) - slope).norm(), rounding * slope.norm());
  EXPECT_LT((gradient_conserving<dim>(particles, neighbors, l.i, n0, Vec<dim>::Zero(), 0) - slope).norm(),
            rounding * slope.norm());
}

TYPED_TEST(Operators, LaplacianIsExactForQuadraticFieldsInsideALattice) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  const Mat<dim> A = some_matrix<dim>();
  for (int j = 0; j < particles.size(); ++j)
    for (int k = 0; k < dim; ++k) particles.u[j][k] = (k + 1) * particles.x[j].dot(A * particles.x[j]);
  const Vec<dim> result = laplacian(l.cloud, l.i, l.reference);
  for (int k = 0; k < dim; ++k) EXPECT_NEAR(result[k], (k + 1) * 2 * A.trace(), rounding);
}

TYPED_TEST(Operators, ApproachSpeedIsThatOfTheFastestPairAcrossFaces) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  const Vec<dim> up = Vec<dim>::Unit(dim - 1), along = Vec<dim>::Unit(0);
  const Vec<dim> kick = -0.01 * up;
  for (int j = 0; j < particles.size(); ++j) {
    const bool wall = particles.x[j][dim - 1] < 3 * l0;
    if (wall) particles.kind[j] = Kind::wall, particles.normal[j] = up;
    particles.u[j] = wall ? Vec<dim>(5 * along) : Vec<dim>(kick);  // walls may slide
  }
  const int wall = l.cloud.nearest(Vec<dim>::Constant(3.5 * l0) - l0 * up);
  EXPECT_EQ(approach_speed(particles, neighbors, l.i, kick, l0), 0);  // the same kick for both
  EXPECT_EQ(approach_speed(particles, neighbors, wall, kick, l0), 0);
  particles.u[l.i] = kick - 3 * up;
  EXPECT_NEAR(approach_speed(particles, neighbors, l.i, kick, l0), 3, rounding);
  EXPECT_NEAR(approach_speed(particles, neighbors, wall, kick, l0), 3, rounding);
  particles.u[l.i] = kick + 3 * up;  // away from the wall, towards the water above
  EXPECT_NEAR(approach_speed(particles, neighbors, l.i, kick, l0), 3, rounding);
  EXPECT_EQ(approach_speed(particles, neighbors, wall, kick, l0), 0);
}

TYPED_TEST(Operators, WaterThatFallsWithAKickDivergesFromWallsThatHaveTheSameKickNowhere) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  const Vec<dim> kick = -0.01 * Vec<dim>::Unit(dim - 1);
  constexpr std::array fixed = {Kind::wall, Kind::dummy, Kind::body_surface, Kind::body_inner};
  for (int j = 0; j < particles.size(); ++j) {
    if (particles.x[j][dim - 1] < 3 * l0) particles.kind[j] = fixed[j % 4];
    particles.u[j] = particles.kind[j] == Kind::fluid ? kick : Vec<dim>::Zero();
  }
  EXPECT_EQ(near_divergence(particles, particles.u, neighbors, l.i, l.reference.n0, kick), 0);
  EXPECT_LT(near_divergence<dim>(particles, particles.u, neighbors, l.i, l.reference.n0, Vec<dim>::Zero()),
            -0.1 * 0.01 / l0);
  const int wall = l.cloud.nearest(Vec<dim>::Constant(3.5 * l0) - l0 * Vec<dim>::Unit(dim - 1));
  EXPECT_EQ(near_divergence(particles, particles.u, neighbors, wall, l.reference.n0, kick), 0);
}

TYPED_TEST(Operators, ABodyThatIsCompressedAlongsideWaterAtRestCompressesNoWater) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  const Vec<dim> up = Vec<dim>::Unit(dim - 1);
  for (int j = 0; j < particles.size(); ++j) {
    const double depth = 3 * l0 - particles.x[j][dim - 1];
    if (depth > 0) particles.kind[j] = depth < l0 ? Kind::body_surface : Kind::body_inner;
    particles.u[j] = depth > l0 ? Vec<dim>(depth * up) : Vec<dim>::Zero();  // its face stands still
  }
  const int face = l.cloud.nearest(Vec<dim>::Constant(3.5 * l0) - l0 * up);
  ASSERT_EQ(particles.kind[face], Kind::body_surface);
  EXPECT_EQ(near_divergence<dim>(particles, particles.u, neighbors, face, l.reference.n0, Vec<dim>::Zero()),
            0);
  particles.u[face] = up;  // the face itself does
  EXPECT_LT(near_divergence<dim>(particles, particles.u, neighbors, face, l.reference.n0, Vec<dim>::Zero()),
            -0.1 / l0);
}

TYPED_TEST(Operators, ThePurelyRepulsiveGradientNeverPullsAPairTogether) {
  constexpr int dim = TypeParam::value;
  Cloud<dim> cloud{.particles = {}, .neighbors = Neighbors<dim>({-Vec<dim>::Ones(), Vec<dim>::Ones()}, 0.5)};
  cloud.particles.add(Kind::fluid, Vec<dim>::Zero());
  cloud.particles.add(Kind::fluid, Vec<dim>::Unit(0) * 0.3);
  cloud.neighbors.rebuild(cloud.particles);
  for (const auto& [p, q] : {std::pair{1.0, 3.0}, {3.0, 1.0}, {2.0, 2.0}}) {
    cloud.particles.p = {p, q};
    // -gradient is the push on the particle; the other one lies along +x for particle 0.
    EXPECT_LE(-gradient_p_min(cloud.particles, cloud.neighbors, 0, 1.0)[0], 0);
    EXPECT_GE(-gradient_p_min(cloud.particles, cloud.neighbors, 1, 1.0)[0], 0);
  }
}

TYPED_TEST(Operators, ThePurelyRepulsiveGradientDoesNotSeeDummies) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  std::fill(particles.p.begin(), particles.p.end(), 1000.0);
  for (int j = 0; j < particles.size(); ++j)
    if (particles.x[j][0] < 3 * l0) particles.kind[j] = Kind::dummy, particles.p[j] = 0;
  // A dummy's pressure of zero in P_min would push with the whole pressure.
  EXPECT_EQ(gradient_p_min(particles, neighbors, l.i, l.reference.n0), Vec<dim>(Vec<dim>::Zero()));
}

TYPED_TEST(Operators, TheConservingGradientSeesTheHydrostaticPressureOfAWallInItsDummies) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  const Vec<dim> rho_g = -9810 * Vec<dim>::Unit(dim - 1);
  for (int j = 0; j < particles.size(); ++j) {
    particles.p[j] = 3000 + rho_g.dot(particles.x[j]);
    if (particles.x[j][dim - 1] < 2 * l0) particles.kind[j] = Kind::dummy, particles.p[j] = -1e9;
  }
  const Vec<dim> gradient = gradient_conserving(particles, neighbors, l.i, l.reference.n0, rho_g, 0);
  EXPECT_LT((gradient - rho_g).norm(), rounding * rho_g.norm());
}

TYPED_TEST(Operators, TheConservingGradientAddsUpToNothingForAnyPressures) {
  constexpr int dim = TypeParam::value;
  auto cloud = block<dim>(test::Counts<dim>::Constant(dim == 2 ? 20 : 8), l0, 0.3);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> pressure(0, 5000);
  for (double& p : cloud.particles.p) p = pressure(random);
  Vec<dim> sum = Vec<dim>::Zero();
  double size = 0;
  for (int i = 0; i < cloud.particles.size(); ++i) {
    const Vec<dim> g =
        gradient_conserving<dim>(cloud.particles, cloud.neighbors, i, 6.5, Vec<dim>::Zero(), 0);
    sum += g;
    size += g.norm();
  }
  EXPECT_GT(size, 1e3);
  EXPECT_LT(sum.norm() / size, 1e-14);  // rounding of 400 terms that cancel in pairs
}

TYPED_TEST(Operators, TheCorrectedGradientIsExactForALinearPressureInDisorder) {
  constexpr int dim = TypeParam::value;
  auto cloud = block<dim>(test::Counts<dim>::Constant(dim == 2 ? 20 : 8), l0, 0.3);
  const Vec<dim> slope = 100 * Vec<dim>::LinSpaced(1, 3);
  auto& particles = cloud.particles;
  for (int i = 0; i < particles.size(); ++i) particles.p[i] = 7 + slope.dot(particles.x[i]);
  double plain = 0;
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.x[i].minCoeff() < l0) continue;  // a corner may have too few neighbours
    EXPECT_LT((gradient_corrected(particles, cloud.neighbors, i, 6.5).gradient - slope).norm(),
              1e-9 * slope.norm())
        << i;
    plain = std::max(plain, (gradient_p_min(particles, cloud.neighbors, i, 6.5) - slope).norm());
  }
  EXPECT_GT(plain, 0.1 * slope.norm());
}

TYPED_TEST(Operators, TheCorrectedGradientStaysFiniteInASingleRow) {
  constexpr int dim = TypeParam::value;
  auto counts = test::Counts<dim>(test::Counts<dim>::Constant(1));
  counts[0] = 10;
  auto cloud = block<dim>(counts, l0);
  for (int i = 0; i < cloud.particles.size(); ++i) cloud.particles.p[i] = 1000 * cloud.particles.x[i][0];
  const Vec<dim> gradient = gradient_corrected(cloud.particles, cloud.neighbors, 5, 6.5).gradient;
  EXPECT_TRUE(gradient.allFinite());
  EXPECT_GT(gradient[0], 0);
}

TYPED_TEST(Operators, TheRepulsionLeavesTheLatticeAsItIsAndPartsACrowdedPair) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  for (int i = 0; i < particles.size(); ++i) particles.p[i] = 1e5 - 9810 * particles.x[i][dim - 1];
  EXPECT_LT(gradient_corrected(particles, neighbors, l.i, l.reference.n0).repulsion.norm(), rounding * 9810);
  particles.x[l.i][0] += 0.3 * l0;  // towards its neighbour on the right
  neighbors.rebuild(particles);
  const int moved = l.cloud.nearest(particles.x[l.i]);
  EXPECT_GT(gradient_corrected(particles, neighbors, moved, l.reference.n0).repulsion[0],
            100);  // a gradient that pushes back
}

TYPED_TEST(Operators, EveningOutLeavesTheLatticeAsItIsAndPartsACrowdedPair) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  auto& [particles, neighbors] = l.cloud;
  EXPECT_LT(even_out(particles, neighbors, l.i, l.reference.n0).norm(), 1e-12);
  particles.x[l.i][0] += 0.3 * l0;  // towards its neighbour on the right
  neighbors.rebuild(particles);
  const int moved = l.cloud.nearest(particles.x[l.i]);
  EXPECT_LT(even_out(particles, neighbors, moved, l.reference.n0)[0], -0.01);
}

TYPED_TEST(Operators, EveningOutStopsBesideTheFreeSurface) {
  constexpr int dim = TypeParam::value;
  Lattice<dim> l;
  Particles<dim>& particles = l.cloud.particles;
  const Neighbors<dim>& neighbors = l.cloud.neighbors;
  particles.x[l.i][0] += 0.3 * l0;
  bool first = true;
  neighbors.each(particles, l.i, [&](int j, const Vec<dim>&, double) {
    if (first) particles.free_surface[j] = 1;
    first = false;
  });
  EXPECT_EQ(even_out(particles, neighbors, l.i, l.reference.n0).norm(), 0);
}

/// Root mean square errors of divergence and Laplacian of a wave, in units of their root mean squares.
template <int dim>
std::pair<double, double> wave_errors(int count, double disorder) {
  const double h = 1.0 / count;
  auto cloud = block<dim>(test::Counts<dim>::Constant(count), h, disorder);
  const ReferenceValues reference = reference_values<dim>(2.1 * h, h);
  auto& particles = cloud.particles;
  constexpr double k = 3;
  for (int i = 0; i < particles.size(); ++i) particles.u[i] = (k * particles.x[i]).array().sin();
  double error_div = 0, error_lap = 0, size_div = 0, size_lap = 0;
  for (int i = 0; i < particles.size(); ++i) {
    const Vec<dim>& x = particles.x[i];
    if (x.minCoeff() < 3 * h || x.maxCoeff() > 1 - 3 * h) continue;
    const double exact = k * (k * x).array().cos().sum();
    const Vec<dim> curvature = -k * k * (k * x).array().sin();
    error_div += std::pow(
        near_divergence<dim>(particles, particles.u, cloud.neighbors, i, reference.n0, Vec<dim>::Zero()) -
            exact,
        2);
    error_lap += (laplacian(cloud, i, reference) - curvature).squaredNorm();
    size_div += exact * exact;
    size_lap += curvature.squaredNorm();
  }
  return {std::sqrt(error_div / size_div), std::sqrt(error_lap / size_lap)};
}

TEST(OperatorsOrder, IsTwoOnTheLattice) {
  const auto [div_coarse, lap_coarse] = wave_errors<2>(32, 0);
  const auto [div_fine, lap_fine] = wave_errors<2>(64, 0);
  // The region grows with the resolution (three spacings less at each side), hence not exactly 2.
  EXPECT_NEAR(std::log2(div_coarse / div_fine), 2, 0.2);
  EXPECT_NEAR(std::log2(lap_coarse / lap_fine), 2, 0.2);
}

// A property of sums without correction, common to all of MPS: where particles are disordered, a linear field
// has an error of the order of the disorder, at any spacing. So the divergence does not converge (order 0),
// and the Laplacian diverges (order -1).
TEST(OperatorsOrder, IsZeroForTheDivergenceAndMinusOneForTheLaplacianInDisorder) {
  const auto [div_coarse, lap_coarse] = wave_errors<2>(32, 0.1);
  const auto [div_fine, lap_fine] = wave_errors<2>(128, 0.1);
  const double order_div = 0.5 * std::log2(div_coarse / div_fine);
  const double order_lap = 0.5 * std::log2(lap_coarse / lap_fine);
  RecordProperty("divergence_error_32", std::to_string(div_coarse));
  RecordProperty("divergence_error_128", std::to_string(div_fine));
  RecordProperty("laplacian_error_32", std::to_string(lap_coarse));
  RecordProperty("laplacian_error_128", std::to_string(lap_fine));
  EXPECT_NEAR(order_div, 0, 0.15);  // statistics of some 600 and 15 000 particles
  EXPECT_NEAR(order_lap, -1, 0.15);
  EXPECT_LT(div_fine, 0.15);  // the size of the disorder
}

}  // namespace
}  // namespace cosurge::fluid
