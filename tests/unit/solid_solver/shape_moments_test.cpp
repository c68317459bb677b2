#include "solid_solver/shape_moments.hpp"

#include <gtest/gtest.h>

#include "common/case/from_case.hpp"
#include "tests/support/outlines.hpp"

namespace cosurge {
namespace {

constexpr double rounding = 1e-14;  // for moments of order one

template <int dim>
void expect_same(const ShapeMoments<dim>& a, const ShapeMoments<dim>& b) {
  EXPECT_NEAR(a.volume, b.volume, rounding);
  EXPECT_NEAR(a.surface, b.surface, rounding);
  EXPECT_LT((a.centre - b.centre).norm(), rounding);
  EXPECT_LT((a.second - b.second).norm(), rounding);
}

template <int dim>
ShapeMoments<dim> moments(const v1::Shape& shape) {
  return ShapeMoments<dim>(from_case<dim>(shape));
}

TEST(ShapeMoments, OfARectangleAreThoseOfItsPolygonEitherWayAround) {
  const v1::Shape box = test::box({0.2, 0.1}, {0.5, 0.9});
  const v1::Shape polygon = test::turned_box({0.2, 0.1}, {0.5, 0.9}, 0);
  v1::Shape reversed;
  for (int k = 3; k >= 0; --k)
    for (int axis = 0; axis < 2; ++axis) reversed.add_vertex(polygon.vertex(2 * k + axis));
  expect_same(moments<2>(box), moments<2>(polygon));
  expect_same(moments<2>(box), moments<2>(reversed));
}

TEST(ShapeMoments, TurnWithTheShape) {
  const double angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  Mat<2> R;
  R << c, -s, s, c;
  const auto straight = moments<2>(test::turned_box({0.2, 0.1}, {0.5, 0.9}, 0)),
             turned = moments<2>(test::turned_box({0.2, 0.1}, {0.5, 0.9}, angle));
  EXPECT_NEAR(turned.volume, 0.24, rounding);
  EXPECT_LT((turned.centre - R * straight.centre).norm(), rounding);
  EXPECT_LT((turned.second - R * straight.second * R.transpose()).norm(), rounding);
}

TEST(ShapeMoments, OfATetrahedronAreTheHandSums) {
  // Integrals over x + y + z < 1 of the functions 1: 1/6; x: 1/24; x^2: 1/60; x y: 1/120.
  const auto found = moments<3>(test::tetrahedron(1, {2, 3, 4}));
  EXPECT_NEAR(found.volume, 1.0 / 6, rounding);
  EXPECT_NEAR(found.surface, 1.5 + std::sqrt(3) / 2, rounding);
  EXPECT_LT((found.centre - Vec<3>(2.25, 3.25, 4.25)).norm(), 10 * rounding);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      EXPECT_NEAR(found.second(a, b), (a == b ? 1.0 / 60 : 1.0 / 120) - 1.0 / 96, rounding);
}

}  // namespace
}  // namespace cosurge
