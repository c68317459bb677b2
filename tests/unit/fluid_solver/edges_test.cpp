// Water at an edge of a wall: the face that it does not see neither stops nor draws it.
#include <gtest/gtest.h>

#include "fluid_solver/operators.hpp"
#include "fluid_solver/pressure/parting_at_faces.hpp"
#include "fluid_solver/seen_faces.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 1;
constexpr double speed = 10;
constexpr double rounding = 1e-9;  // of sums of up to 268 terms of the order of the speed
constexpr double edge = 12;        // the wall fills x < edge, height < edge

template <typename T>
class Edge : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Edge, Dimensions);

/// A wall with an edge, and water over its upper face that goes on beyond the edge, or beside its side face.
template <int dim>
test::Cloud<dim> wall_and_water(bool above) {
  test::Counts<dim> counts = test::Counts<dim>::Constant(9);
  counts[0] = counts[dim - 1] = 24;
  auto cloud = test::block<dim>(counts, l0, 0, 4);
  Particles<dim>& all = cloud.particles;
  std::vector<std::int32_t> kept;
  for (int i = 0; i < all.size(); ++i) {
    const double below = edge - all.x[i][dim - 1], inside = edge - all.x[i][0];
    const bool in_wall = below > 0 && inside > 0;
    if (in_wall) {
      all.kind[i] = std::min(below, inside) < l0 ? Kind::wall : Kind::dummy;
      all.normal[i] = Vec<dim>::Unit(below <= inside ? dim - 1 : 0);
    } else {
      all.u[i] = speed * Vec<dim>::Unit(above ? 0 : dim - 1);
    }
    if (in_wall || (above ? below < 0 : below > 0)) kept.push_back(i);
  }
  all.reorder(kept);
  cloud.neighbors.rebuild(all);
  return cloud;
}

/// Whether x lies in the middle plane near the edge, and not beyond both faces.
template <int dim>
bool before_one_face(const Vec<dim>& x) {
  return std::abs(x[0] - edge) < 5 && std::abs(x[dim - 1] - edge) < 5 && (dim == 2 || x[1] == 4.5) &&
         (x[0] < edge || x[dim - 1] < edge);
}

template <int dim>
double parting(const test::Cloud<dim>& cloud, int i) {
  const FaceRule<dim> rule{.re = 4, .spacing = l0, .face_factor = 1.7, .kick = Vec<dim>::Zero()};
  return parting_at_faces<dim>(cloud.particles, cloud.particles.u, cloud.neighbors.grid(), i, rule);
}

/// Expects neither divergence nor approach at particle i.
template <int dim>
void expect_undisturbed(const test::Cloud<dim>& cloud, int i) {
  const Particles<dim>& all = cloud.particles;
  EXPECT_NEAR(parting(cloud, i), 0, rounding) << all.x[i].transpose();
  EXPECT_NEAR(approach_speed<dim>(all, cloud.neighbors, i, Vec<dim>::Zero(), l0), 0, rounding)
      << all.x[i].transpose();
}

TYPED_TEST(Edge, WaterThatRunsAlongAFaceToItsEdgeHasNoDivergence) {
  constexpr int dim = TypeParam::value;
  for (const bool above : {true, false}) {
    const auto cloud = wall_and_water<dim>(above);
    const Particles<dim>& all = cloud.particles;
    int seen = 0;
    for (int i = 0; i < all.size(); ++i) {
      if (!before_one_face<dim>(all.x[i]) || all.kind[i] != Kind::fluid) continue;
      ++seen;
      expect_undisturbed(cloud, i);
    }
    EXPECT_GT(seen, 20);
  }
}

TYPED_TEST(Edge, WaterBehindAFaceDoesNotCountInItsRows) {
  constexpr int dim = TypeParam::value;
  const auto cloud = wall_and_water<dim>(false);
  const Particles<dim>& all = cloud.particles;
  int seen = 0;
  for (int i = 0; i < all.size(); ++i) {
    if (!before_one_face<dim>(all.x[i]) || all.kind[i] != Kind::wall || all.normal[i][0] != 0) continue;
    ++seen;
    expect_undisturbed(cloud, i);
  }
  EXPECT_GT(seen, 3);
}

TEST(SeenFaces, KeepsNormalsOfCurvedFacesAndReplacesThoseOfHiddenOnes) {
  SeenFaces<2> faces(l0);
  const Vec<2> up(0, 1), aside(1, 0), nearly_up = Vec<2>(0.4, 0.9).normalized();
  faces.add(up, {0, -1}, true);
  EXPECT_FALSE(faces.at_edge());
  EXPECT_EQ(faces.normal(aside), aside) << "nothing is hidden";
  faces.add(aside, {1, -1}, true);  // its face lies beyond the water
  EXPECT_TRUE(faces.at_edge());
  EXPECT_EQ(faces.normal(aside), up);
  EXPECT_EQ(faces.normal(nearly_up), nearly_up);
  faces.add(aside, {-1.5, 0}, true);  // a second face with this normal, before which the water lies
  EXPECT_EQ(faces.normal(aside), aside);
}

}  // namespace
}  // namespace cosurge::fluid
