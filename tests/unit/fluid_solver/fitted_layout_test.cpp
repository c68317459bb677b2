#include "fluid_solver/fitted_layout.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>

#include "common/case/from_case.hpp"
#include "fluid_solver/reference_values.hpp"
#include "fluid_solver/weight.hpp"
#include "tests/support/wall_layouts.hpp"

namespace cosurge::fluid {
namespace {

using std::numbers::pi;
using test::to_nearest;

constexpr double l0 = 0.01;
constexpr int dummies = 3;

template <int dim>
std::vector<WallSite<dim>> layout_of(const v1::Shape& outline) {
  return fitted_layout<dim>(from_case<dim>(outline), std::nullopt, dummies, l0);
}

template <int dim>
std::vector<Vec<dim>> sorted(const std::vector<WallSite<dim>>& sites, Kind kind) {
  std::vector<Vec<dim>> points = test::of_kind(sites, kind);
  std::sort(points.begin(), points.end(), [](const Vec<dim>& a, const Vec<dim>& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return points;
}

v1::Shape box_of(const std::vector<double>& min, const std::vector<double>& max) {
  v1::Shape shape;
  shape.mutable_min()->Assign(min.begin(), min.end());
  shape.mutable_max()->Assign(max.begin(), max.end());
  return shape;
}

TEST(FittedLayout, ABoxGivenAsAnOutlineHasTheParticlesOfTheBox) {
  const auto flat = layout_of<2>(test::outline_of<2>({{0.1, 0}, {0.3, 0}, {0.3, 0.15}, {0.1, 0.15}}));
  const auto flat_box = layout_of<2>(box_of({0.1, 0}, {0.3, 0.15}));
  const auto solid =
      layout_of<3>(test::outline_of<3>(test::triangles_of_box({0.1, 0, 0}, {0.25, 0.12, 0.1})));
  const auto solid_box = layout_of<3>(box_of({0.1, 0, 0}, {0.25, 0.12, 0.1}));
  for (const Kind kind : {Kind::wall, Kind::dummy}) {
    EXPECT_EQ(sorted(flat, kind), sorted(flat_box, kind));
    EXPECT_EQ(sorted(solid, kind), sorted(solid_box, kind));
  }
  EXPECT_EQ(flat.size(), 20u * 15);
  EXPECT_EQ(test::of_kind(solid, Kind::wall).size(), 15u * 12 * 10 - 13u * 10 * 8);
}

TEST(FittedLayout, FacesOnLatticePlanesKeepTheLattice) {
  // An angle iron with a slope far from the rest.
  const auto sites = layout_of<2>(
      test::outline_of<2>({{0, 0}, {0.4, 0}, {0.4, 0.1}, {0.15, 0.1}, {0.15, 0.3}, {0.07, 0.3}, {0, 0.22}}));
  for (const auto& [x, kind] : sites) {
    if (x[0] < 0.2 && x[1] > 0.12) continue;
    const Vec<2> k = (x / l0).array() - 0.5;
    EXPECT_LT((k - Vec<2>(k.array().round())).norm(), 1e-9) << x.transpose();
  }
}

/// Depths and distances of the particles of a turned box.
template <int dim>
void check_faces(const v1::Shape& outline, const std::string& which) {
  const auto shape = from_case<dim>(outline);
  const auto sites = layout_of<dim>(outline);
  const auto walls = test::of_kind(sites, Kind::wall), inner = test::of_kind(sites, Kind::dummy);
  double shallow = 1, deep = 0, nearest = 9, farthest = 0, gap_low = 9, gap_high = 0;
  for (const Vec<dim>& x : walls) {
    const double depth = (shape.nearest(x) - x).norm() / l0;
    shallow = std::min(shallow, depth);
    deep = std::max(deep, depth);
    const double beside = to_nearest(x, walls) / l0, behind = to_nearest(x, inner) / l0;
    nearest = std::min(nearest, beside);
    farthest = std::max(farthest, beside);
    gap_low = std::min(gap_low, behind);
    // Behind the outer edges of the box the second layer is farther away.
    int faces = 0;
    for (const auto& facet : shape.facets()) {
      const Vec<dim> normal = normal_of(facet).normalized();
      faces += std::abs(normal.dot(x - facet[0])) < 1.6 * l0 ? 1 : 0;
    }
    if (faces <= dim - 1) gap_high = std::max(gap_high, behind);
  }
  EXPECT_GT(shallow, 0.49) << which;
  EXPECT_LT(deep, 0.51) << which;
  EXPECT_GT(nearest, 0.85) << which;
  EXPECT_LT(farthest, 1.15) << which;
  EXPECT_GT(gap_low, 0.85) << which;
  EXPECT_LT(gap_high, 1.15) << which;
  EXPECT_GT(test::least_distance(sites) / l0, 0.7) << which;
}

TEST(FittedLayout, ObliqueFacesHaveEvenLayersBelowThem) {
  for (const int degrees : {10, 20, 30, 45, 60}) {
    const double angle = degrees * pi / 180;
    check_faces<2>(test::turned_box(Vec<2>(20.3 * l0, 6.8 * l0), angle), fmt::format("2-D, {}", degrees));
    const Vec<3> half(8.3 * l0, 5.7 * l0, 6.2 * l0);
    check_faces<3>(test::turned_box(half, angle), fmt::format("3-D, {}", degrees));
    check_faces<3>(test::turned_box(half, angle, 0.4), fmt::format("3-D turned twice, {}", degrees));
  }
}

/// Largest difference of what the walls add to the number density one spacing outside the first layer, in
/// parts of n0, along the middle of the upper face.
template <int dim>
double roughness(const v1::Shape& outline, const Vec<dim>& centre, const Vec<dim>& along, double length) {
  const double re = 2.1 * l0;
  const auto sites = layout_of<dim>(outline);
  double low = 1e9, high = 0;
  for (double s = -length; s <= length; s += 0.05 * l0) {
    double n = 0;
    for (const auto& site : sites) {
      const double r = (site.x - centre - s * along).norm();
      n += weight(r, re);
    }
    low = std::min(low, n);
    high = std::max(high, n);
  }
  return (high - low) / reference_values<dim>(re, l0).n0;
}

TEST(FittedLayout, AFaceLooksTheSameAllAlongFromTheWater) {
  for (const int degrees : {10, 20, 30, 45, 60}) {
    const double angle = degrees * pi / 180;
    const Vec<2> half(20.3 * l0, 6.8 * l0);
    const Vec<2> along(std::cos(angle), std::sin(angle)), up(-along[1], along[0]);
    const double flat = roughness<2>(test::turned_box(half, angle), (6.8 + 0.5) * l0 * up, along, 12 * l0);
    const Vec<3> along3(along[0], 0, along[1]), up3(up[0], 0, up[1]);
    const double solid = roughness<3>(test::turned_box(Vec<3>(8.3 * l0, 5.7 * l0, 6.2 * l0), angle),
                                      (6.2 + 0.5) * l0 * up3 + 0.2 * l0 * Vec<3>::UnitY(), along3, 4 * l0);
    EXPECT_LT(flat, 0.03) << degrees;
    EXPECT_LT(solid, 0.03) << degrees;
  }
}

/// All wall particles of a round body at their depth, as many as its surface there has room for.
template <int dim>
void check_round(const v1::Shape& outline, double surface, const std::string& which) {
  const auto shape = from_case<dim>(outline);
  const auto sites = layout_of<dim>(outline);
  const auto walls = test::of_kind(sites, Kind::wall);
  double nearest = 9, farthest = 0;
  for (const Vec<dim>& x : walls) {
    EXPECT_NEAR((shape.nearest(x) - x).norm() / l0, 0.5, 0.02);
    nearest = std::min(nearest, to_nearest(x, walls) / l0);
    farthest = std::max(farthest, to_nearest(x, walls) / l0);
  }
  const double share = static_cast<double>(walls.size()) / surface * std::pow(l0, dim - 1);
  EXPECT_NEAR(share, 1, 0.03) << which;
  EXPECT_GT(test::least_distance(sites) / l0, 0.7) << which;
}

TEST(FittedLayout, RoundBodiesHaveEvenLayers) {
  for (const double radius : {0.1, 0.153, 0.3}) {
    const double at = radius - 0.5 * l0;
    check_round<2>(test::circle(radius, 200), 2 * pi * at, fmt::format("circle {}", radius));
    check_round<2>(test::circle(radius, 64), 2 * pi * at, fmt::format("polygon {}", radius));
  }
  for (const double radius : {0.06, 0.1}) {
    const double at = radius - 0.5 * l0;
    check_round<3>(test::sphere(radius, 60), 4 * pi * at * at, fmt::format("sphere {}", radius));
  }
}

/// Distance of the farthest point of the first layer's surface from a particle.
template <int dim>
double largest_hole(const v1::Shape& outline) {
  const auto shape = from_case<dim>(outline);
  std::vector<Vec<dim>> particles;
  for (const auto& site : layout_of<dim>(outline)) particles.push_back(site.x);
  double largest = 0;
  const double pitch = (dim == 2 ? 0.05 : 0.4) * l0;
  const Vec<dim> margin = Vec<dim>::Constant(pitch);
  for (const Vec<dim>& x : fill(Box<dim>(shape.bounds().min - margin, shape.bounds().max + margin), pitch)) {
    const double depth = (shape.nearest(x) - x).norm();
    if (!shape.contains(x) || std::abs(depth - 0.5 * l0) > 0.6 * pitch) continue;
    largest = std::max(largest, to_nearest(x, particles));
  }
  return largest;
}

TEST(FittedLayout, CornersHaveNoHolesAndNoCrowds) {
  const std::vector<std::vector<Vec<2>>> outlines = {
      {{0, 0.2}, {0.17, 0.1}, {0.31, 0.19}, {0.27, 0.33}, {0.152, 0.23}, {0.03, 0.35}},  // concave above
      {{0, 0}, {0.3, 0}, {0.3, 0.1}, {0.13, 0.1}, {0.13, 0.3}, {0, 0.3}},                // an angle
      {{0.11, 0}, {0.32, 0.02}, {0.21, 0.26}}};                                          // sharp corners
  for (const auto& corners : outlines) {
    const v1::Shape outline = test::outline_of<2>(corners);
    const double hole = largest_hole<2>(outline) / l0,
                 least = test::least_distance(layout_of<2>(outline)) / l0;
    EXPECT_LT(hole, 0.75);  // to the next particle: 1.5 spacings across
    EXPECT_GT(least, 0.7);
  }
  const v1::Shape solid = test::turned_box(Vec<3>(8.3 * l0, 5.7 * l0, 6.2 * l0), 0.5, 0.4);
  const double hole = largest_hole<3>(solid) / l0;
  const double ball = largest_hole<3>(test::sphere(0.08, 40)) / l0;
  EXPECT_LT(hole, 0.8);  // with points that lie up to a quarter of a spacing off the layer
  EXPECT_LT(ball, 0.8);
}

TEST(FittedLayout, DoesNotDependOnTheNumberOfThreads) {
  const v1::Shape outline = test::sphere(0.08, 40);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = layout_of<3>(outline);
  omp_set_num_threads(3);
  const auto three = layout_of<3>(outline);
  omp_set_num_threads(threads);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k)
    EXPECT_TRUE(one[k].x == three[k].x && one[k].kind == three[k].kind);
}

TEST(FittedLayout, AThinPlateIsFilled) {
  for (const double thickness : {0.6, 1.0, 1.4, 2.0, 3.3}) {
    const v1::Shape outline = test::turned_box(Vec<2>(20 * l0, 0.5 * thickness * l0), 0.4);
    const auto sites = layout_of<2>(outline);
    EXPECT_GT(test::least_distance(sites) / l0, 0.7) << thickness;
    EXPECT_GE(sites.size(), 20u) << thickness;
  }
}

TEST(FittedLayout, OverlappingPartsKeepTheLattice) {
  std::vector<Vec<3>> corners = test::triangles_of_box({0, 0, 0}, {0.083, 0.1, 0.1});
  for (const Vec<3>& x : test::triangles_of_box({0.043, 0.02, 0.02}, {0.2, 0.08, 0.08})) corners.push_back(x);
  const auto shape = from_case<3>(test::outline_of<3>(corners));
  EXPECT_EQ(layout_of<3>(test::outline_of<3>(corners)).size(), shape.fill(l0).size());
}

}  // namespace
}  // namespace cosurge::fluid
