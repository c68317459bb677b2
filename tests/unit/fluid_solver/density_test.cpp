#include "fluid_solver/density.hpp"

#include <gtest/gtest.h>

#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using test::block;
using test::Cloud;

constexpr double l0 = 0.01;
constexpr double printed = 6e-4;  // half of the last digit of the values below, and its rounding

template <int dim>
double n0() {
  return reference_values<dim>(2.1 * l0, l0).n0;
}

template <int dim>
bool flagged(Cloud<dim>& cloud, int i, double beta, double delta) {
  density_and_free_surface(cloud.particles, cloud.neighbors, n0<dim>(), {.beta = beta, .delta = delta * l0});
  return cloud.particles.free_surface[i] != 0;
}

/// n / n0 and the centroid's deviation of a particle; the deviation is where the flag changes its mind.
template <int dim>
void expect_values(Cloud<dim>& cloud, const Vec<dim>& x, double density, double deviation) {
  const int i = cloud.nearest(x);
  EXPECT_TRUE(flagged(cloud, i, 0.999, deviation - printed));
  EXPECT_FALSE(flagged(cloud, i, 0.999, deviation + printed));
  EXPECT_NEAR(cloud.particles.n[i] / n0<dim>(), density, printed);
}

TEST(FreeSurface, ValuesOnTheSquareLatticeAreTheHandSums) {
  auto cloud = block<2>({12, 12}, l0);
  expect_values<2>(cloud, {0.5 * l0, 6 * l0}, 0.676, 0.491);
  expect_values<2>(cloud, {1.5 * l0, 6 * l0}, 0.992, 0.015);
  expect_values<2>(cloud, {0.5 * l0, 0.5 * l0}, 0.426, 0.856);
}

TEST(FreeSurface, ValuesOnTheCubicLatticeAreTheHandSums) {
  auto cloud = block<3>({8, 8, 8}, l0);
  expect_values<3>(cloud, {0.5 * l0, 4 * l0, 4 * l0}, 0.727, 0.381);
  expect_values<3>(cloud, {1.5 * l0, 4 * l0, 4 * l0}, 0.9965, 0.007);
  expect_values<3>(cloud, {0.5 * l0, 0.5 * l0, 4 * l0}, 0.517, 0.585);
}

/// Layers between a particle and the nearest face of a block of `counts`.
template <int dim>
double depth(const Vec<dim>& x, int count) {
  return std::min((x / l0).minCoeff(), count - (x / l0).maxCoeff());
}

template <int dim>
void expect_outer_layer_only(int count) {
  auto cloud = block<dim>(test::Counts<dim>::Constant(count), l0);
  density_and_free_surface(cloud.particles, cloud.neighbors, n0<dim>(), {.beta = 0.97, .delta = 0.2 * l0});
  for (int i = 0; i < cloud.particles.size(); ++i)
    EXPECT_EQ(cloud.particles.free_surface[i] != 0, depth<dim>(cloud.particles.x[i], count) < 1) << i;
}

TEST(FreeSurface, IsTheOuterLayerOfABlockAndNothingElse) {
  expect_outer_layer_only<2>(10);
  expect_outer_layer_only<3>(7);
}

TEST(FreeSurface, AThinnedInteriorIsNoSurface) {
  // Every particle of the block stretched by 5 % has n < 0.97 n0, but its neighbours lie all around.
  auto cloud = block<2>({12, 12}, 1.05 * l0, 0, 2.1 / 1.05);
  const int i = cloud.nearest({6 * l0, 6 * l0});
  EXPECT_FALSE(flagged(cloud, i, 0.97, 0.2));
  EXPECT_LT(cloud.particles.n[i], 0.97 * n0<2>());
}

TEST(FreeSurface, AFewParticlesAloneAreFreeHoweverTheyLie) {
  Cloud<2> cloud{.particles = {}, .neighbors = Neighbors<2>({{-l0, -l0}, {l0, l0}}, 2.1 * l0)};
  for (const double x : {-0.5, 0.0, 0.5}) cloud.particles.add(Kind::fluid, {x * l0, 0});
  cloud.neighbors.rebuild(cloud.particles);
  // The one in the middle has its centroid in itself.
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(flagged(cloud, i, 0.97, 0.2));
}

TEST(NumberDensity, CountsDummiesAndIsNotAskedOfThem) {
  auto cloud = block<2>({8, 8}, l0);
  const int i = cloud.nearest({4 * l0, 4 * l0});
  for (int j = 0; j < cloud.particles.size(); ++j)
    if (j != i) cloud.particles.kind[j] = j % 2 == 0 ? Kind::dummy : Kind::body_inner;
  cloud.neighbors.rebuild(cloud.particles);
  const int again = cloud.nearest({4 * l0, 4 * l0});
  EXPECT_FALSE(flagged(cloud, again, 0.97, 0.2));
  EXPECT_NEAR(cloud.particles.n[again] / n0<2>(), 1, 1e-12);  // rounding of twelve terms
  EXPECT_EQ(cloud.particles.n[cloud.nearest({4 * l0, 2 * l0})], 0);
}

}  // namespace
}  // namespace cosurge::fluid
