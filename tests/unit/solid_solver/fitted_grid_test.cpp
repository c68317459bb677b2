#include "solid_solver/models/fem/fitted_grid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <bit>
#include <numbers>

#include "common/case/from_case.hpp"
#include "common/error.hpp"
#include "solid_solver/shape_moments.hpp"
#include "tests/support/outlines.hpp"

namespace cosurge::fem {
namespace {

template <int dim>
using Corners = Eigen::Matrix<double, dim, QuadraticElement<dim>::nodes>;

template <int dim>
Corners<dim> corners_of(const FittedGrid<dim>& grid, std::size_t element) {
  Corners<dim> corners;
  for (int a = 0; a < corners.cols(); ++a)
    corners.col(a) = grid.position.col(grid.node[element][static_cast<std::size_t>(a)]);
  return corners;
}

/// Volume from the elements' Gauss points.
template <int dim>
double volume_of(const FittedGrid<dim>& grid) {
  double volume = 0;
  for (std::size_t e = 0; e < grid.node.size(); ++e)
    for (const auto& sample : QuadraticElement<dim>::gauss())
      volume +=
          sample.weight * (corners_of(grid, e) * QuadraticElement<dim>::gradients(sample.xi)).determinant();
  return volume;
}

/// Least determinant at a Gauss point over the cell's.
template <int dim>
double least_jacobian(const FittedGrid<dim>& grid) {
  double least = 1;
  for (std::size_t e = 0; e < grid.node.size(); ++e)
    for (const auto& sample : QuadraticElement<dim>::gauss())
      least =
          std::min(least, (corners_of(grid, e) * QuadraticElement<dim>::gradients(sample.xi)).determinant() /
                              (grid.side.prod() / (1 << dim)));
  return least;
}

template <int dim>
double relative_error(const v1::Shape& outline, double longest, double* jacobian = nullptr) {
  const auto shape = from_case<dim>(outline);
  const FittedGrid<dim> grid(shape, longest, 0);
  if (jacobian != nullptr) *jacobian = least_jacobian(grid);
  return volume_of(grid) / ShapeMoments<dim>(shape).volume - 1;
}

TEST(FittedGrid, OfABoxesOutlineIsTheBoxesTurnedToo) {
  const v1::Shape box = test::box({0.2, 0.1}, {0.5, 0.9});
  const FittedGrid<2> even(from_case<2>(box), 0.1, 0);
  const double angle = 0.4, c = std::cos(angle), s = std::sin(angle);
  const FittedGrid<2> turned(from_case<2>(test::turned_box({0.2, 0.1}, {0.5, 0.9}, angle)), 0.1, 0);
  Mat<2> R;
  R << c, -s, s, c;
  ASSERT_EQ(even.node, turned.node);
  EXPECT_LT((R * even.position - turned.position).cwiseAbs().maxCoeff(), 1e-14);  // rounding
}

TEST(FittedGrid, HasTheAreaOfADisk) {
  // Straight elements would be off by h^2 / (24 r^2) about, curved ones of second order by h^4.
  double coarse = 0, fine = 0;
  const double first = relative_error<2>(test::disk({1, 2}, 1, 960), 0.25, &coarse);
  const double second = relative_error<2>(test::disk({1, 2}, 1, 960), 0.125, &fine);
  RecordProperty("area_error", fmt::format("{:.2e} {:.2e}", first, second));
  RecordProperty("least_jacobian", fmt::format("{:.3f} {:.3f}", coarse, fine));
  EXPECT_LT(std::abs(first), 1e-3);
  EXPECT_LT(std::abs(second), 1e-4);
  EXPECT_GT(std::min(coarse, fine), 0.05);
}

TEST(FittedGrid, HasThePolygonsAreaExactly) {
  const v1::Shape tapered = test::outline<2>({{0, 0}, {1, 0.1}, {1, 0.2}, {0, 0.3}});
  const v1::Shape wedge = test::outline<2>({{0, 0}, {1, 0}, {0, 0.6}});
  const v1::Shape angle = test::outline<2>({{0, 0}, {1, 0.2}, {0.9, 0.5}, {0.4, 0.4}, {0.2, 1}, {-0.1, 0.9}});
  for (const v1::Shape& shape : {tapered, wedge, angle}) {
    double quality = 0;
    for (const double longest : {0.06, 0.04, 0.02}) {
      // Straight sides between corners that are nodes: rounding.
      EXPECT_LT(std::abs(relative_error<2>(shape, longest, &quality)), 1e-13);
      EXPECT_GT(quality, 0.05);  // the least are at vertices that were steps of stairs
    }
  }
}

/// An icosahedron whose triangles are parted into four, twice, and moved out to the sphere.
v1::Shape ball(double radius) {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  const std::vector<Vec<3>> v = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  const int faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                            {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                            {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                            {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  std::vector<Vec<3>> corners;
  for (const auto& face : faces)
    for (const int k : face) corners.push_back(radius * v[static_cast<std::size_t>(k)].normalized());
  for (int parting = 0; parting < 2; ++parting) {
    std::vector<Vec<3>> finer;
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      const Vec<3>&a = corners[k], &b = corners[k + 1], &c = corners[k + 2];
      const Vec<3> ab = radius * (a + b).normalized(), bc = radius * (b + c).normalized(),
                   ca = radius * (c + a).normalized();
      for (const Vec<3>& x : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) finer.push_back(x);
    }
    corners = finer;
  }
  return test::outline<3>(corners);
}

TEST(FittedGrid, HasTheVolumeOfABall) {
  double quality = 0;
  const double error = relative_error<3>(ball(1), 0.4, &quality);
  RecordProperty("error", fmt::format("{:.2e}, least Jacobian {:.3f}", error, quality));
  EXPECT_LT(std::abs(error), 0.01);  // nodes on the facets, between them polynomials
  EXPECT_GT(quality, 0.01);
}

/// A body with flat faces between sharp edges.
struct Sharp {
  const char* name;
  v1::Shape shape;
  double thickness;    // elements are some parts of it
  double off = 1e-11;  // share of the volume; default: rounding, for flat faces and followed creases
};

/// About an axis that is not a coordinate axis.
Mat<3> aslant() { return Eigen::AngleAxisd(0.7, Vec<3>(1, -2, 0.5).normalized()).toRotationMatrix(); }

class SharpEdges : public testing::TestWithParam<Sharp> {};

TEST_P(SharpEdges, AreKeptSoThatTheVolumeIsExact) {
  for (const double parts : {3.0, 4.0, 6.0}) {
    double quality = 0;
    const double error = relative_error<3>(GetParam().shape, GetParam().thickness / parts, &quality);
    RecordProperty(fmt::format("{}_parts", parts),
                   fmt::format("{:.1e}, least Jacobian {:.3f}", error, quality));
    EXPECT_LT(std::abs(error), GetParam().off);  // asked 1 %
    EXPECT_GT(quality, 0.005);  // the least are at vertices that were steps of stairs, in space of three ways
  }
}

TEST_P(SharpEdges, AreTheSameInABodyThatIsTurned) {
  v1::Shape turned = GetParam().shape;
  for (int k = 0; k < turned.vertex_size(); k += 3)
    Eigen::Map<Vec<3>>(turned.mutable_vertex()->mutable_data() + k) =
        aslant() * Eigen::Map<const Vec<3>>(GetParam().shape.vertex().data() + k);
  double quality = 0;
  EXPECT_LT(std::abs(relative_error<3>(turned, GetParam().thickness / 4, &quality)), GetParam().off);
  EXPECT_GT(quality, 0.005);
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, SharpEdges,
    testing::Values(
        Sharp{"prism", test::prism(1, 0.6, 0.5), 0.4},
        Sharp{"flap", test::extruded({{0, -10}, {100, -5}, {100, 5}, {0, 10}}, 24), 20},
        Sharp{"bracket", test::extruded({{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}}, 0.6, 3),
              0.3},
        Sharp{"arms",
              test::extruded({{0, 0}, {1, 0.2}, {0.9, 0.5}, {0.4, 0.4}, {0.2, 1}, {-0.1, 0.9}}, 0.4, 3), 0.35,
              1e-3},  // two vertices of four parts would make elements too flat
        Sharp{"tetrahedron", test::tetrahedron(1, {0, 0, 0}), 0.53}),
    [](const auto& choice) { return std::string(choice.param.name); });

TEST(FittedGrid, HasTheVolumeOfACylinderToItsRims) {
  // 96 sides: the rims are closed, the face between them is smooth.
  std::vector<Vec<2>> rim;
  for (int k = 0; k < 96; ++k)
    rim.emplace_back(std::cos(k * std::numbers::pi / 48), std::sin(k * std::numbers::pi / 48));
  for (const double longest : {0.5, 0.25}) {
    double quality = 0;
    const double error = relative_error<3>(test::extruded(rim, 1.5), longest, &quality);
    RecordProperty(fmt::format("{}", longest), fmt::format("{:.1e}, least Jacobian {:.3f}", error, quality));
    EXPECT_LT(std::abs(error), 1e-3);  // as the disk's
    EXPECT_GT(quality, 0.05);
  }
}

TEST(FittedGrid, ThatCannotFollowItsShapeIsRefused) {
  // An octahedron of two or three coarse elements' height, and a cone, whose tip the smoothing empties.
  std::vector<Vec<3>> octahedron, cone;
  for (int k = 0; k < 8; ++k) {
    const Vec<3> a(k & 1 ? -1 : 1, 0, 0), b(0, k & 2 ? -1 : 1, 0), c(0, 0, k & 4 ? -1 : 1);
    const bool odd = std::popcount(static_cast<unsigned>(k)) % 2 == 1;
    for (const Vec<3>& x : {a, odd ? c : b, odd ? b : c}) octahedron.push_back(x);
  }
  const auto rim = [](int k) {
    return Vec<3>(std::cos(k * std::numbers::pi / 24), std::sin(k * std::numbers::pi / 24), 0);
  };
  for (int k = 0; k < 48; ++k)
    for (const Vec<3>& x : {rim(k), rim(k + 1), Vec<3>(0, 0, 1.2), rim(k + 1), rim(k), Vec<3>(0, 0, 0)})
      cone.push_back(x);
  EXPECT_THROW(FittedGrid<3>(from_case<3>(test::outline<3>(octahedron)), 0.4, 0), Error);
  EXPECT_NO_THROW(FittedGrid<3>(from_case<3>(test::outline<3>(octahedron)), 0.2, 0));
  EXPECT_THROW(FittedGrid<3>(from_case<3>(test::outline<3>(cone)), 0.2, 0), Error);
}

TEST(FittedGrid, ThatFallsApartIsRefused) {
  // Two squares and a strip that is thinner than the cells.
  const auto dumbbell = from_case<2>(test::outline<2>({{0, 0},
                                                       {1, 0},
                                                       {1, 0.42},
                                                       {2, 0.42},
                                                       {2, 0},
                                                       {3, 0},
                                                       {3, 1},
                                                       {2, 1},
                                                       {2, 0.58},
                                                       {1, 0.58},
                                                       {1, 1},
                                                       {0, 1}}));
  EXPECT_THROW(FittedGrid<2>(dumbbell, 0.5, 0), Error);
  EXPECT_NO_THROW(FittedGrid<2>(dumbbell, 0.08, 0));
}

}  // namespace
}  // namespace cosurge::fem
