#include "solid_solver/models/particles/body_grid.hpp"

#include <gtest/gtest.h>

#include "tests/support/solid_cases.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::particles {
namespace {

using test::l0;

BodyGrid<2> clamped_plate() {
  return {test::body_of<2>(test::plate({.columns = 12, .rows = 80}).solid().body(0)), 0,
          full_stencil<2>(l0, 2.1)};
}

TEST(BodyGrid, KeepsOfAClampOnlyWhatFreeParticlesFeel) {
  const BodyGrid<2> grid = clamped_plate();
  std::size_t held = 0;
  for (std::size_t p = 0; p < grid.positions().size(); ++p) {
    if (!grid.held(p)) continue;
    ++held;
    EXPECT_GT(grid.positions()[p][1], -2 * l0);  // two rows lie within 2.1 spacings of the free ones
  }
  EXPECT_EQ(held, 24u);
  EXPECT_EQ(grid.positions().size(), 24u + 12u * 80u);
}

TEST(BodyGrid, ANeighboursSlotIsOneShiftAwayForEveryParticle) {
  const BodyGrid<2> grid = clamped_plate();
  const Stencil<2> stencil = full_stencil<2>(l0, 2.1);
  std::vector<long> particle_of_slot(static_cast<std::size_t>(grid.slots()), -1);
  for (std::size_t p = 0; p < grid.positions().size(); ++p)
    particle_of_slot[static_cast<std::size_t>(grid.slot(p))] = static_cast<long>(p);
  for (std::size_t p = 0; p < grid.positions().size(); ++p) {
    for (const Neighbor<2>& n : stencil.neighbors) {
      const Vec<2> x = grid.positions()[p] + n.r0;
      EXPECT_EQ(particle_of_slot[static_cast<std::size_t>(grid.slot(p) + grid.shift(n.offset))],
                grid.particle_at(x));
    }
  }
}

TEST(BodyGrid, FindsParticlesByTheirPlace) {
  const BodyGrid<2> grid = clamped_plate();
  for (std::size_t p = 0; p < grid.positions().size(); ++p)
    EXPECT_EQ(grid.particle_at(grid.positions()[p]), static_cast<long>(p));
  EXPECT_EQ(grid.particle_at({0.0061, 0.0405}), -1);
  EXPECT_EQ(grid.particle_at({0.5, 0.5}), -1);
  EXPECT_EQ(grid.particles_near({0.006, 0.04}, 1.01 * l0).size(), 4u);
}

}  // namespace
}  // namespace cosurge::particles
