#include "fluid_solver/bodies.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>
#include <utility>

#include "tests/support/make_mps.hpp"
#include "tests/support/outlines.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using test::box_of;
using test::solid_of;

constexpr double l0 = 0.01;
constexpr double rounding = 1e-13;  // for areas of order l0 and coordinates of order one

const Box<2> tank2({0, 0}, {0.5, 0.5});
const Box<3> tank3({0, 0, 0}, {0.5, 0.5, 0.5});

Bodies<2> free_plate() { return test::bodies_of<2>(solid_of(box_of({0.1, 0.1}, {0.14, 0.17})), tank2, l0); }
Bodies<3> free_brick() {
  return test::bodies_of<3>(solid_of(box_of({0.1, 0.1, 0.1}, {0.14, 0.17, 0.13})), tank3, l0);
}

template <int dim>
Field affine(const Bodies<dim>& bodies, const Mat<dim>& F, const Vec<dim>& shift) {
  Field displacement(dim, bodies.points());
  for (int k = 0; k < bodies.points(); ++k)
    displacement.col(k) = F * bodies.position(k) + shift - bodies.position(k);
  return displacement;
}

/// Deformed areas against Nanson's formula worked out with the F that was put in.
template <int dim>
void expect_nanson(const Bodies<dim>& bodies, const Mat<dim>& F) {
  const Field A_0 = bodies.interface().area;
  const auto areas = bodies.deformed(affine<dim>(bodies, F, Vec<dim>::Constant(0.3))).area;
  for (int k = 0; k < bodies.points(); ++k) {
    const Vec<dim> exact = F.determinant() * F.inverse().transpose() * A_0.col(k);
    EXPECT_LT((areas[k] - exact).norm(), rounding) << k;
  }
}

TEST(BodySurface, AreasOfAFreeBodyAddUpToNothingSoUniformPressureGivesNoForce) {
  EXPECT_LT(free_plate().interface().area.rowwise().sum().norm(), rounding * l0);
  EXPECT_LT(free_brick().interface().area.rowwise().sum().norm(), rounding * l0);
}

TEST(BodySurface, AreasOfAnOutlineAddUpToNothingAndFaceWhatTheyProject) {
  v1::Solid disk, corner;
  *disk.add_body()->mutable_shape() = cosurge::test::disk({0.212, 0.207}, 0.1);
  *corner.add_body()->mutable_shape() = cosurge::test::tetrahedron(0.2, {0.1, 0.11, 0.12});
  const auto flat = test::bodies_of<2>(disk, tank2, l0);
  const auto solid = test::bodies_of<3>(corner, tank3, l0);
  EXPECT_LT(flat.interface().area.rowwise().sum().norm(), rounding * l0);
  EXPECT_LT(solid.interface().area.rowwise().sum().norm(), rounding * l0);
  // What faces one way along an axis is the shadow along it: the diameter, the leg's triangle; a site more or
  // less.
  EXPECT_NEAR(flat.interface().area.row(0).cwiseMax(0).sum(), 0.2, 2.001 * l0);
  EXPECT_NEAR(solid.interface().area.row(2).cwiseMax(0).sum(), 0.02, 0.2 * 2 * l0);
}

TEST(BodySurface, EveryFaceIsCountedOnce) {
  // Sum of |components| = perimeter of 4 x 7 cells, surface of 4 x 7 x 3.
  EXPECT_NEAR(free_plate().interface().area.cwiseAbs().sum(), 2 * (4 + 7) * l0, rounding);
  EXPECT_NEAR(free_brick().interface().area.cwiseAbs().sum(), 2 * (28 + 21 + 12) * l0 * l0, rounding);
  EXPECT_EQ(free_plate().points(), 28);
  int inner = 0;
  for (int k = 0; k < 84; ++k) inner += free_brick().wet(k) ? 0 : 1;
  EXPECT_EQ(inner, 2 * 5 * 1);
}

// Pressures belong to the centres of the surface particles, half a spacing inside the faces: a body of N
// layers floats like one of N - 1. First order in the spacing, and exactly this much.
template <int dim>
void expect_buoyancy(const Bodies<dim>& bodies, double volume_between_centres) {
  const Interface interface = bodies.interface();
  const Vec<dim> rho_g = -9810 * Vec<dim>::Unit(1);
  Vec<dim> force = Vec<dim>::Zero();
  for (int k = 0; k < bodies.points(); ++k)
    force -= (5000 + rho_g.dot(bodies.position(k))) * interface.area.col(k);
  EXPECT_LT((force + rho_g * volume_between_centres).norm(), 1e-12 * 5000 * l0);
}

TEST(BodySurface, HydrostaticPressureGivesTheBuoyancyOfTheVolumeBetweenTheOuterCentres) {
  expect_buoyancy(free_plate(), 4 * (7 - 1) * l0 * l0);
  expect_buoyancy(free_brick(), 4 * (7 - 1) * 3 * l0 * l0 * l0);
}

/// The first of the wet points of its body that are nearest to point k.
int nearest_wet_point(const Bodies<3>& bodies, int k) {
  std::pair nearest(std::numeric_limits<double>::max(), -1);
  for (int j = 0; j < bodies.points(); ++j)
    if (bodies.wet(j) && bodies.body(j) == bodies.body(k))
      nearest = std::min(nearest, std::pair((bodies.position(j) - bodies.position(k)).squaredNorm(), j));
  return nearest.second;
}

TEST(BodySurface, InnerPointsOfThickBodiesBelongToTheNearestWetPointOfTheirBody) {
  v1::Solid two = solid_of(box_of({0.1, 0.1, 0.1}, {0.24, 0.25, 0.23}));
  *two.add_body() = solid_of(box_of({0.24, 0.1, 0.1}, {0.29, 0.25, 0.23})).body(0);
  const auto bodies = test::bodies_of<3>(two, tank3, l0);
  for (int k = 0; k < bodies.points(); ++k)
    EXPECT_EQ(bodies.face_point(k), nearest_wet_point(bodies, k)) << k;
}

TEST(BodySurface, TurnsWithARigidRotation) {
  for (const double degrees : {30.0, 90.0}) {
    const double angle = degrees * EIGEN_PI / 180;
    const Mat<2> R = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Bodies<2> plate = free_plate();
    const auto turned = plate.deformed(affine<2>(plate, R, {0.1, 0.2})).area;
    for (int k = 0; k < plate.points(); ++k)
      EXPECT_LT((turned[k] - R * plate.interface().area.col(k)).norm(), rounding);
    expect_nanson<3>(free_brick(), Eigen::AngleAxisd(angle, Vec<3>(1, 2, 2) / 3).toRotationMatrix());
  }
}

TEST(BodySurface, StretchesAndShearsByNansonsFormula) {
  const Mat<2> stretch = Vec<2>(1.25, 0.8).asDiagonal();
  const Mat<2> shear{{1, 0.4}, {0, 1}};
  expect_nanson<2>(free_plate(), stretch);
  expect_nanson<2>(free_plate(), shear);
  const Mat<3> brick_stretch = Vec<3>(1.25, 0.8, 1.1).asDiagonal();
  const Mat<3> brick_shear{{1, 0.4, 0}, {0, 1, -0.2}, {0.1, 0, 1}};
  expect_nanson<3>(free_brick(), brick_stretch);
  expect_nanson<3>(free_brick(), brick_shear);
  // By hand: a face with its normal along x grows with the stretch along y, and shear along x leaves it
  // upright but tilts the normal of the side faces.
  const Bodies<2> plate = free_plate();
  const auto wide = plate.deformed(affine<2>(plate, stretch, {0, 0})).area;
  const auto tilted = plate.deformed(affine<2>(plate, shear, {0, 0})).area;
  for (int k = 0; k < plate.points(); ++k) {
    if (plate.interface().area.col(k) != Vec<2>(-l0, 0)) continue;
    EXPECT_LT((wide[k] - Vec<2>(-0.8 * l0, 0)).norm(), rounding);
    EXPECT_LT((tilted[k] - Vec<2>(-l0, 0.4 * l0)).norm(), rounding);
  }
}

/// Sum of |A| along an axis, outward to `side` (-1, +1).
template <int dim>
double facing(const Bodies<dim>& bodies, int axis, double side) {
  return (side * bodies.interface().area.row(axis)).cwiseMax(0).sum();
}

TEST(BodySurface, FacesTowardsAClampAndTheFloorAreNotWet) {
  const v1::Box plate = box_of({0.1, 0}, {0.13, 0.08});
  const auto on_floor = test::bodies_of<2>(solid_of(plate), tank2, l0);
  const auto clamped = test::bodies_of<2>(solid_of(plate, {box_of({0.1, -0.03}, {0.13, 0})}), tank2, l0);
  const auto hanging = test::bodies_of<2>(
      solid_of(box_of({0.1, 0.2}, {0.13, 0.28}), {box_of({0.1, 0.28}, {0.13, 0.3})}), tank2, l0);
  const auto at_side = test::bodies_of<2>(solid_of(box_of({0, 0.2}, {0.08, 0.23})), tank2, l0);
  EXPECT_NEAR(facing(on_floor, 1, -1), 0, rounding);
  EXPECT_NEAR(facing(clamped, 1, -1), 0, rounding);
  EXPECT_NEAR(facing(clamped, 1, +1), 3 * l0, rounding);
  EXPECT_NEAR(facing(clamped, 0, -1), 8 * l0, rounding);
  EXPECT_NEAR(facing(clamped, 0, +1), 8 * l0, rounding);
  EXPECT_NEAR(facing(hanging, 1, +1), 0, rounding);
  EXPECT_NEAR(facing(hanging, 1, -1), 3 * l0, rounding);
  EXPECT_NEAR(facing(at_side, 0, -1), 0, rounding);
  EXPECT_NEAR(facing(at_side, 0, +1), 3 * l0, rounding);
}

TEST(BodySurface, BodiesThatTouchKeepTheirOwnDeformation) {
  v1::Solid solid = solid_of(box_of({0.1, 0.1}, {0.13, 0.14}));
  *solid.add_body()->mutable_box() = box_of({0.13, 0.1}, {0.16, 0.14});
  const auto bodies = test::bodies_of<2>(solid, tank2, l0);
  Field displacement = Field::Zero(2, bodies.points());
  const Interface interface = bodies.interface();
  for (int k = 0; k < bodies.points(); ++k)
    if (interface.body[k] == 1) displacement(0, k) = 0.05;  // the second one has gone away
  const auto areas = bodies.deformed(displacement).area;
  for (int k = 0; k < bodies.points(); ++k) EXPECT_LT((areas[k] - interface.area.col(k)).norm(), rounding);
}

}  // namespace
}  // namespace cosurge::fluid
