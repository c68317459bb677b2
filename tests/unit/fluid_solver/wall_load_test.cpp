// The load of still water on obstacles and on the sides of the tank.
#include "fluid_solver/wall_load.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "common/case/from_case.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/outlines.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;
constexpr double rho_g = 9810;

template <int dim>
Vec<dim> total_area(const std::vector<FacePiece<dim>>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), Vec<dim>(Vec<dim>::Zero()),
                         [](const Vec<dim>& sum, const FacePiece<dim>& piece) { return sum + piece.area; });
}

/// Integral of x . dA over dim: the volume inside.
template <int dim>
double volume(const std::vector<FacePiece<dim>>& pieces) {
  double sum = 0;
  for (const FacePiece<dim>& piece : pieces) sum += piece.place.dot(piece.area) / dim;
  return sum;
}

TEST(FacePieces, CloseAroundAShapeAndFaceOutwardsWhateverTheOrderOfItsCorners) {
  const std::vector<Vec<2>> corners = {{0.1, 0.1}, {0.3, 0.15}, {0.2, 0.3}};
  for (const auto& order : {corners, std::vector<Vec<2>>(corners.rbegin(), corners.rend())}) {
    const auto pieces = pieces_of(from_case<2>(cosurge::test::outline<2>(order)), 0.005);
    EXPECT_LT(total_area(pieces).norm(), 1e-12);
    EXPECT_NEAR(volume(pieces), 0.0175, 1e-12);
  }
  const auto box = pieces_of(from_case<3>(shape_of(test::box_of({0, 0, 0}, {0.1, 0.2, 0.3}))), 0.02);
  EXPECT_LT(total_area(box).norm(), 1e-12);
  EXPECT_NEAR(volume(box), 0.006, 1e-12);
  for (const auto& piece : box) EXPECT_LE(piece.area.norm(), 0.5 * 0.02 * 0.02);
}

TEST(FacePieces, LeaveOutWhatLiesInsideAnotherPartOfTheOutline) {
  // Two boxes in space as one outline that overlap by half.
  v1::Shape both = cosurge::test::extruded({{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}}, 0.1);
  const v1::Shape other = cosurge::test::extruded({{0.1, 0.02}, {0.3, 0.02}, {0.3, 0.08}, {0.1, 0.08}}, 0.1);
  both.mutable_vertex()->MergeFrom(other.vertex());
  const auto pieces = pieces_of(from_case<3>(both), 0.002);
  const double exact = 0.2 * 0.1 * 0.1 + 0.1 * 0.06 * 0.1;
  EXPECT_NEAR(volume(pieces), exact, 0.01 * exact);  // pieces that the intersection cuts count whole or not
}

/// A tank of 0.6 x 0.3 m with water 0.2 m deep, and the probed obstacle first among the obstacles.
v1::Fluid tank_with(const std::vector<v1::Shape>& obstacles) {
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.6, 0.3}), {test::box_of({0, 0}, {0.6, 0.2})});
  for (const v1::Shape& shape : obstacles) *fluid.add_obstacle()->mutable_shape() = shape;
  return fluid;
}

v1::Shape box(const std::vector<double>& min, const std::vector<double>& max) {
  return shape_of(test::box_of(min, max));
}

/// Values of the particles, by id.
template <int dim>
std::vector<std::int32_t> places(const Mps<dim>& mps) {
  std::vector<std::int32_t> place(static_cast<std::size_t>(mps.initial_size()));
  for (int i = 0; i < mps.particles().size(); ++i) place[mps.particles().id[i]] = i;
  return place;
}

/// After a short time at rest.
Load<2> load(const v1::Fluid& fluid, const ProbeMount& mount, const Vec<2>& about,
             const v1::Solid* solid = nullptr) {
  auto mps = test::mps_of<2>(fluid, solid, {0, -9.81});
  const WallLoad<2> wall(mps, mount, about);
  constexpr double dt = 5e-4;
  constexpr int steps = 20;
  for (int k = 0; k < steps; ++k) (void)mps.step(k * dt, dt);
  return wall.read(mps, places(mps), steps * dt);
}

constexpr ProbeMount first_obstacle{.on = ProbeMount::On::obstacle, .number = 0};
constexpr ProbeMount floor_side{.on = ProbeMount::On::face, .axis = 1};
constexpr ProbeMount left{.on = ProbeMount::On::face, .axis = 0};
constexpr ProbeMount right{.on = ProbeMount::On::face, .axis = 0, .upper = true};

// The tolerances of 1 % are those of the hydrostatic pressure on this lattice (docs/verification.md).
TEST(WallLoad, OfASunkBoxIsItsBuoyancyAboutItsMiddle) {
  const Load<2> sunk = load(tank_with({box({0.2, 0.05}, {0.3, 0.1})}), first_obstacle, {0.1, 0.2});
  const double buoyancy = rho_g * 0.1 * 0.05;
  EXPECT_NEAR(sunk.force[1], buoyancy, 0.01 * buoyancy);
  EXPECT_NEAR(sunk.force[0], 0, 0.01 * buoyancy);
  EXPECT_NEAR(sunk.moment[2], 0.15 * buoyancy, 0.01 * 0.15 * buoyancy);
}

TEST(WallLoad, OfATriangleUnderWaterIsItsBuoyancyOnceTheWaterHasSettledAroundIt) {
  v1::Fluid fluid = tank_with({cosurge::test::outline<2>({{0.2, 0.05}, {0.36, 0.05}, {0.28, 0.15}})});
  auto mps = test::mps_of<2>(fluid, nullptr, {0, -9.81});
  const WallLoad<2> wall(mps, first_obstacle, {0.28, 0.05});
  constexpr double dt = 1e-3;
  constexpr int first = 200, last = 500;
  Vec<2> sum = Vec<2>::Zero();
  for (int k = 0; k < last; ++k) {
    (void)mps.step(k * dt, dt);
    if (k >= first) sum += wall.read(mps, places(mps), (k + 1) * dt).force / (last - first);
  }
  const double buoyancy = rho_g * 0.5 * 0.16 * 0.1;
  EXPECT_NEAR(sum[1], buoyancy, 0.02 * buoyancy);
  EXPECT_NEAR(sum[0], 0, 0.02 * buoyancy);
}

TEST(WallLoad, DoesNotPushWhereAnotherWallCovers) {
  // A step on the floor: water stands on it and beside it, not under it.
  const Load<2> step = load(tank_with({box({0.2, 0}, {0.3, 0.1})}), first_obstacle, {0.2, 0});
  const double weight = rho_g * 0.1 * 0.1;
  EXPECT_NEAR(step.force[1], -weight, 0.01 * weight);
  EXPECT_NEAR(step.force[0], 0, 0.01 * weight);
  // And the floor carries the water above it, with 0.1 m left out.
  const Load<2> floor = load(tank_with({box({0.2, 0}, {0.3, 0.1})}), floor_side, {0, 0});
  EXPECT_NEAR(floor.force[1], -rho_g * 0.2 * 0.5, 0.01 * rho_g * 0.2 * 0.5);
}

TEST(WallLoad, DoesNotPushWhereABodyCovers) {
  const v1::Solid block = test::solid_of(test::box_of({0.2, 0}, {0.3, 0.1}));
  const Load<2> floor = load(tank_with({}), floor_side, {0, 0}, &block);
  EXPECT_NEAR(floor.force[1], -rho_g * 0.2 * 0.5, 0.01 * rho_g * 0.2 * 0.5);
}

TEST(WallLoad, OfASideOfTheTankIsThatOfItsDepthAndActsAtAThirdOfIt) {
  const double thrust = rho_g * 0.2 * 0.2 / 2;
  v1::Fluid inviscid = tank_with({});
  inviscid.set_kinematic_viscosity(0);
  const Load<2> on_left = load(inviscid, left, {0, 0});
  const Load<2> on_right = load(inviscid, right, {0.6, 0});
  EXPECT_NEAR(on_left.force[0], -thrust, 0.01 * thrust);
  EXPECT_NEAR(on_right.force[0], thrust, 0.01 * thrust);
  EXPECT_EQ(on_left.force[1], 0);
  EXPECT_NEAR(on_left.moment[2], thrust * 0.2 / 3, 0.02 * thrust * 0.2 / 3);
  EXPECT_NEAR(on_right.moment[2], -thrust * 0.2 / 3, 0.02 * thrust * 0.2 / 3);
}

TEST(WallLoad, OfASunkBoxInSpaceIsItsBuoyancy) {
  v1::Fluid fluid = test::tank_of_water(0.02, test::box_of({0, 0, 0}, {0.3, 0.3, 0.3}),
                                        {test::box_of({0, 0, 0}, {0.3, 0.3, 0.2})});
  *fluid.add_obstacle()->mutable_shape() = box({0.1, 0.1, 0.06}, {0.2, 0.2, 0.12});
  auto mps = test::mps_of<3>(fluid, nullptr, {0, 0, -9.81});
  const WallLoad<3> wall(mps, first_obstacle, {0.05, 0.15, 0.09});
  for (int k = 0; k < 10; ++k) (void)mps.step(k * 1e-3, 1e-3);
  const Load<3> sunk = wall.read(mps, places(mps), 0.01);
  const double buoyancy = rho_g * 0.1 * 0.1 * 0.06;
  EXPECT_LT((sunk.force - Vec<3>(0, 0, buoyancy)).norm(), 0.02 * buoyancy);
  // r x F with the arm (0.1, 0, 0): about the y axis, negative.
  EXPECT_LT((sunk.moment - Vec<3>(0, -0.1 * buoyancy, 0)).norm(), 0.02 * 0.1 * buoyancy);
}

}  // namespace
}  // namespace cosurge::fluid
