// The side of elements where the case does not give one.
#include "solid_solver/models/fem/chosen_grid.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "common/error.hpp"
#include "solid_solver/models/fem/mesh.hpp"
#include "solid_solver/shape_moments.hpp"
#include "tests/support/outlines.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::fem {
namespace {

/// A column of 24 sides.
v1::Shape column(double radius, double height) {
  std::vector<Vec<2>> corners;
  for (int k = 0; k < 24; ++k) {
    const double angle = 2 * std::numbers::pi * k / 24;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return test::extruded(corners, height);
}

Body<3> body_of(const v1::Shape& shape) {
  v1::Body body;
  *body.mutable_shape() = shape;
  return test::body_of<3>(body);
}

TEST(ChosenGrid, AnOutlineInSpaceGetsSome250Elements) {
  const Mesh<3> mesh(body_of(column(0.02, 0.1)), 0, 0);
  EXPECT_GE(mesh.elements(), 150);
  EXPECT_LE(mesh.elements(), 500);  // a third of 2 volume / surface makes more than a thousand
  EXPECT_GT(FittedGrid<3>(from_case<3>(column(0.02, 0.1)), 0, 0).node.size(), 800U);
}

TEST(ChosenGrid, TakesShorterElementsWhereTheOutlineAsksForThem) {
  // An angle of thin legs: 250 cubes are nearly twice as thick as these, and cannot be fitted to them.
  const double t = 0.002, l = 0.03;
  const auto angle = from_case<3>(test::extruded({{0, 0}, {l, 0}, {l, t}, {t, t}, {t, l}, {0, l}}, 0.4, 3));
  EXPECT_THROW(FittedGrid<3>(angle, std::cbrt(ShapeMoments<3>(angle).volume / 250), 0), Error);
  EXPECT_GT(chosen_grid(angle, 0, 0).node.size(), 250U);
}

TEST(ChosenGrid, BoxesPolygonsAndGivenSidesAreAsBefore) {
  const auto disk = from_case<2>(test::disk({0, 0}, 1));
  EXPECT_EQ(chosen_grid(disk, 0, 0).node, FittedGrid<2>(disk, 0, 0).node);
  const auto box = from_case<3>(test::box({0, 0, 0}, {0.1, 0.02, 0.3}));
  EXPECT_EQ(chosen_grid(box, 0, 0).node, FittedGrid<3>(box, 0, 0).node);
  const auto round = from_case<3>(column(0.02, 0.1));
  EXPECT_EQ(chosen_grid(round, 0.01, 0).node, FittedGrid<3>(round, 0.01, 0).node);
}

}  // namespace
}  // namespace cosurge::fem
