#include "fluid_solver/neighbors.hpp"

#include <gtest/gtest.h>

#include <random>

#include "common/error.hpp"
#include "common/threads.hpp"

namespace cosurge::fluid {
namespace {

template <typename T>
class NeighborLists : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NeighborLists, Dimensions);

using Lists = std::vector<std::vector<int>>;

template <int dim>
Particles<dim> random_particles(int count, double side) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(0, side);
  Particles<dim> particles;
  for (int i = 0; i < count; ++i) {
    Vec<dim> x;
    for (double& c : x) c = coordinate(random);
    particles.add(i % 5 == 0 ? Kind::dummy : Kind::fluid, x);
  }
  return particles;
}

template <int dim>
Lists listed(const Neighbors<dim>& neighbors, const Particles<dim>& particles) {
  Lists lists(particles.x.size());
  for (int i = 0; i < particles.size(); ++i)
    neighbors.each(particles, i, [&](int j, const Vec<dim>& x_ij, double r) {
      EXPECT_EQ(x_ij, particles.x[j] - particles.x[i]);
      EXPECT_EQ(r, x_ij.norm());
      lists[i].push_back(j);
    });
  for (int i = 0; i < particles.size(); ++i) {
    std::vector<int> weighted;
    neighbors.each_weighted(particles, i, [&](int j, const Vec<dim>& x_ij, double r, double w) {
      EXPECT_EQ(x_ij, particles.x[j] - particles.x[i]);
      EXPECT_EQ(r, x_ij.norm());
      EXPECT_EQ(w, weight(r, neighbors.re()));
      weighted.push_back(j);
    });
    EXPECT_EQ(weighted, lists[i]);
  }
  return lists;
}

/// All pairs, in ascending order; dummies have no neighbours.
template <int dim>
Lists all_pairs(const Particles<dim>& particles, double re) {
  Lists lists(particles.x.size());
  for (int i = 0; i < particles.size(); ++i)
    for (int j = 0; has_pressure(particles.kind[i]) && j < particles.size(); ++j)
      if (j != i && (particles.x[j] - particles.x[i]).squaredNorm() < re * re) lists[i].push_back(j);
  return lists;
}

template <int dim>
Box<dim> cube(double from, double to) {
  return {Vec<dim>::Constant(from), Vec<dim>::Constant(to)};
}

TYPED_TEST(NeighborLists, AreThoseOfAllPairsInAscendingOrder) {
  constexpr int dim = TypeParam::value;
  constexpr double re = 0.7;  // does not divide the domain
  auto particles = random_particles<dim>(dim == 2 ? 900 : 1500, dim == 2 ? 12 : 6);
  Neighbors<dim> neighbors(cube<dim>(0, dim == 2 ? 12 : 6), re);
  neighbors.rebuild(particles);
  const Lists lists = listed(neighbors, particles);
  EXPECT_EQ(lists, all_pairs(particles, re));
  std::size_t pairs = 0;
  for (int i = 0; i < particles.size(); ++i) {
    pairs += lists[i].size();
    EXPECT_EQ(neighbors.count(i), static_cast<int>(lists[i].size()));
  }
  EXPECT_GT(pairs, 2u * particles.x.size());  // the comparison was not one of empty lists
}

TYPED_TEST(NeighborLists, AreMutualBetweenParticlesWithPressure) {
  constexpr int dim = TypeParam::value;
  auto particles = random_particles<dim>(700, 5);
  Neighbors<dim> neighbors(cube<dim>(-1, 6), 0.9);
  neighbors.rebuild(particles);
  const Lists lists = listed(neighbors, particles);
  for (int i = 0; i < particles.size(); ++i) {
    for (const int j : lists[i]) {
      const bool seen = std::binary_search(lists[j].begin(), lists[j].end(), i);
      EXPECT_EQ(seen, has_pressure(particles.kind[j])) << i << ", " << j;
    }
  }
}

TYPED_TEST(NeighborLists, ParticlesKeepTheirIdentityAndThoseOutsideAreGone) {
  constexpr int dim = TypeParam::value;
  auto particles = random_particles<dim>(500, 5);
  const auto before = particles.x;
  const Box<dim> domain = cube<dim>(1, 4);
  Neighbors<dim> neighbors(domain, 0.5);  // divides the domain: its upper faces are outside
  neighbors.rebuild(particles);
  std::vector<bool> kept(before.size(), false);
  for (int i = 0; i < particles.size(); ++i) {
    EXPECT_EQ(particles.x[i], before[particles.id[i]]);
    EXPECT_EQ(particles.kind[i] == Kind::dummy, particles.id[i] % 5 == 0);
    kept[particles.id[i]] = true;
  }
  for (std::size_t id = 0; id < before.size(); ++id) EXPECT_EQ(kept[id], domain.contains(before[id])) << id;
}

TYPED_TEST(NeighborLists, LieInTheOrderOfTheCells) {
  constexpr int dim = TypeParam::value;
  auto particles = random_particles<dim>(500, 5);
  Neighbors<dim> neighbors(cube<dim>(0, 5), 0.8);
  neighbors.rebuild(particles);
  const CellGrid<dim>& grid = neighbors.grid();
  int place = 0;
  for (int cell = 0; cell < grid.cells(); ++cell) {
    for (int k = 0; k < grid.population(cell); ++k, ++place) {
      EXPECT_EQ(grid.first(cell) + k, place);
      EXPECT_EQ(grid.number(grid.cell_of(particles.x[place])), cell);
      EXPECT_TRUE(k == 0 || particles.id[place - 1] < particles.id[place]) << place;  // stable
    }
  }
  EXPECT_EQ(place, particles.size());
}

TYPED_TEST(NeighborLists, AreTheSameForAnyNumberOfThreads) {
  constexpr int dim = TypeParam::value;
  Lists first;
  for (const int threads : {1, 2, 4}) {
    set_threads(threads);
    auto particles = random_particles<dim>(3000, dim == 2 ? 20 : 8);
    Neighbors<dim> neighbors(cube<dim>(0, 20), 1.0);
    neighbors.rebuild(particles);
    const Lists lists = listed(neighbors, particles);
    if (first.empty()) first = lists;
    EXPECT_EQ(lists, first);
  }
}

TYPED_TEST(NeighborLists, CrowdedRowsGetMoreRoomAndThenAreAllThere) {
  constexpr int dim = TypeParam::value;
  // Some 70 neighbours in the plane and 240 in space where 20 and 50 are expected: more than a chunk has room
  // for.
  auto particles = random_particles<dim>(dim == 2 ? 1200 : 4000, dim == 2 ? 6.0 : 3.2);
  Neighbors<dim> neighbors(cube<dim>(0, dim == 2 ? 6.0 : 3.2), 1.0);
  ASSERT_NO_THROW(neighbors.rebuild(particles));
  const Lists lists = listed(neighbors, particles);
  std::size_t most = 0;
  for (std::size_t c = 0; c < lists.size(); c += Rows::chunk) {
    std::size_t chunk = 0;
    for (std::size_t i = c; i < std::min(lists.size(), c + Rows::chunk); ++i) chunk += lists[i].size();
    most = std::max(most, chunk);
  }
  EXPECT_GT(most, static_cast<std::size_t>((dim == 2 ? 20 : 50) * Rows::chunk + most_entries(dim)));
  EXPECT_EQ(lists, all_pairs(particles, 1.0));
}

TYPED_TEST(NeighborLists, ACollapsedCellEndsTheRunInWords) {
  constexpr int dim = TypeParam::value;
  auto particles = random_particles<dim>(400, 0.9);  // all in one cell
  Neighbors<dim> neighbors(cube<dim>(0, 3), 1.0);
  try {
    neighbors.rebuild(particles);
    FAIL() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("400 particles lie in one cell"), std::string::npos)
        << error.what();
  }
}

// The widest radius that a case may ask for must not be taken for a collapse.
TYPED_TEST(NeighborLists, ALatticeIsNoCollapseForAnyRadiusOfACase) {
  constexpr int dim = TypeParam::value;
  for (const double re : {1.5, 2.1, 3.1, 4.0}) {
    Particles<dim> particles;
    for (const Vec<dim>& x : fill(cube<dim>(0, 9), 1.0)) particles.add(Kind::fluid, x);
    Neighbors<dim> neighbors(cube<dim>(-0.25, 9.25), re);
    EXPECT_NO_THROW(neighbors.rebuild(particles)) << re;
  }
}

}  // namespace
}  // namespace cosurge::fluid
