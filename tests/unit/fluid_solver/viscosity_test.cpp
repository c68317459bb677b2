// Viscosity beside walls: the water has the wall's velocity on its face.
#include "fluid_solver/viscosity.hpp"

#include <gtest/gtest.h>

#include "fluid_solver/direct_force.hpp"
#include "fluid_solver/reference_values.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;
constexpr double shear = 3;  // 1/s
constexpr double face = 4 * l0;
constexpr double rounding = 1e-10;  // of a Laplacian of the order of shear / l0

template <typename T>
class Viscosity : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Viscosity, Dimensions);

/// Water in plane shear flow on a floor that moves along x, and the fall that both have in a step.
template <int dim>
struct ShearedWater {
  ShearedWater() : cloud(test::block<dim>(test::Counts<dim>::Constant(12), l0)) {
    Particles<dim>& all = cloud.particles;
    for (int i = 0; i < all.size(); ++i) {
      const double height = all.x[i][dim - 1] - face;
      all.u[i] = floor;
      if (height > 0) {
        all.u[i] += shear * height * Vec<dim>::Unit(0) + fall;
        continue;
      }
      all.kind[i] = height > -l0 ? Kind::wall : Kind::dummy;
      all.normal[i] = Vec<dim>::Unit(dim - 1);
    }
    cloud.neighbors.rebuild(all);
  }
  /// Whether no side of the block is within the radius.
  bool in_the_middle(int i) const {
    const Vec<dim>& x = cloud.particles.x[i];
    return x.minCoeff() > 3 * l0 && x.maxCoeff() < 9 * l0;
  }

  Vec<dim> floor = 0.7 * Vec<dim>::Unit(0);
  Vec<dim> fall = -0.02 * Vec<dim>::Unit(dim - 1);
  ReferenceValues reference = reference_values<dim>(2.1 * l0, l0);
  test::Cloud<dim> cloud;
};

TYPED_TEST(Viscosity, PlaneShearFlowOnAMovingWallHasNoViscousForceDownToTheWall) {
  constexpr int dim = TypeParam::value;
  const ShearedWater<dim> water;
  int seen = 0;
  for (int i = 0; i < water.cloud.particles.size(); ++i) {
    if (water.cloud.particles.kind[i] != Kind::fluid || !water.in_the_middle(i)) continue;
    const FaceBefore<dim> before = face_before(water.cloud.particles, water.cloud.neighbors, i, l0);
    if (before.place >= 0) ++seen;
    const Vec<dim> laplacian = velocity_laplacian(water.cloud.particles, water.cloud.neighbors, i, before,
                                                  water.fall, water.reference.n0, water.reference.lambda0);
    EXPECT_LT(laplacian.norm(), rounding * shear / l0) << i;
  }
  EXPECT_GT(seen, 5);
}

constexpr double rho = 1000, nu = 1e-3;

template <int dim>
DirectForce<dim> friction(const ShearedWater<dim>& water) {
  const auto& [particles, neighbors] = water.cloud;
  DirectForce<dim> force;
  force.clear(particles.size());
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::fluid) continue;
    const FaceBefore<dim> before = face_before(particles, neighbors, i, l0);
    if (before.place >= 0) force.note_rubbing(i);
  }
  const double mass = rho * std::pow(l0, dim);
  force.add_friction(particles, neighbors, l0, water.fall,
                     mass * nu * 2 * dim / (water.reference.lambda0 * water.reference.n0));
  return force;
}

// rho nu du/dy on each l0^(d-1) of the wall.
TYPED_TEST(Viscosity, FrictionOnTheWallIsTheShearStress) {
  constexpr int dim = TypeParam::value;
  const ShearedWater<dim> water;
  Vec<dim> middle = Vec<dim>::Constant(6.5 * l0);
  middle[dim - 1] = face - l0 / 2;
  const Vec<dim> exact = rho * nu * shear * std::pow(l0, dim - 1) * Vec<dim>::Unit(0);
  EXPECT_LT((friction(water).on(water.cloud.nearest(middle)) - exact).norm(), rounding * exact.norm());
}

TYPED_TEST(Viscosity, WaterThatRotatesWithItsWallsRubsOnNone) {
  constexpr int dim = TypeParam::value;
  ShearedWater<dim> water;
  auto& [particles, neighbors] = water.cloud;
  const Mat<dim> any = test::some_matrix<dim>();
  const Mat<dim> spin = any - any.transpose();
  for (int i = 0; i < particles.size(); ++i)
    particles.u[i] =
        spin * particles.x[i] + (particles.kind[i] == Kind::fluid ? water.fall : Vec<dim>::Zero());
  const DirectForce<dim> force = friction(water);
  int seen = 0;
  for (int j = 0; j < particles.size(); ++j) {
    if (particles.kind[j] != Kind::wall || !water.in_the_middle(j)) continue;
    ++seen;
    EXPECT_LT(force.on(j).norm(), rounding * rho * nu * spin.norm() * std::pow(l0, dim - 1));
  }
  EXPECT_GT(seen, 3);
}

}  // namespace
}  // namespace cosurge::fluid
