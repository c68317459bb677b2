#include "fluid_solver/lost_water.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Ten particles of water in a tank of 1 x 1 m, and a wall.
struct Scene {
  explicit Scene(double most_lost = 1) {
    fluid = test::tank_of_water(0.1, test::box_of({0, 0}, {1, 1}), {test::box_of({0, 0}, {1, 0.1})});
    fluid.set_most_lost(most_lost);
    for (int k = 0; k < 10; ++k) particles.add(Kind::fluid, {0.05 + 0.1 * k, 0.05});
    particles.add(Kind::wall, {0.05, -0.05});
  }

  void put(int id, const Vec<2>& x) { particles.x[static_cast<std::size_t>(place(id))] = x; }

  void take(int id) {
    std::vector<std::int32_t> rest;
    for (int i = 0; i < particles.size(); ++i)
      if (i != place(id)) rest.push_back(i);
    particles.reorder(rest);
  }

  int place(int id) const {
    return static_cast<int>(std::find(particles.id.begin(), particles.id.end(), id) - particles.id.begin());
  }

  v1::Fluid fluid;
  Particles<2> particles;
};

TEST(LostWater, IsCountedAtTheSideWhereItWasLast) {
  Scene scene;
  LostWater<2> lost(water_from_case<2>(scene.fluid, Vec<2>::Zero()), scene.particles);
  EXPECT_THAT(lost.values(), ElementsAre(10, 0, 0, 0, 0, 0));
  EXPECT_EQ(lost.columns()[1].name, "lost_x_min");
  EXPECT_EQ(lost.columns()[4].name, "lost_y_max");
  scene.put(3, {-0.01, 1.2});  // over the rim on the left
  scene.put(4, {0.99, 0.9});   // at the right wall
  scene.put(5, {0.5, -0.05});  // through the floor
  scene.put(6, {1.05, 0.5});   // through the right wall
  scene.put(7, {0.5, 1.9});    // out of the top
  lost.before_step(scene.particles);
  for (const int id : {3, 4, 5, 6, 7}) scene.take(id);
  lost.after_step(scene.particles, 0.1);
  EXPECT_THAT(lost.values(), ElementsAre(5, 1, 2, 1, 1, 2));
  lost.before_step(scene.particles);
  lost.after_step(scene.particles, 0.2);
  EXPECT_THAT(lost.values(), ElementsAre(5, 1, 2, 1, 1, 2));
}

TEST(LostWater, IsSeenFromTheMovingTank) {
  Scene scene;
  for (const double value : {0.0, 0.0, 0.0, 0.0, 1.0, 5.0, 0.0, 0.0})
    scene.fluid.mutable_tank_motion()->add_row(value);
  LostWater<2> lost(water_from_case<2>(scene.fluid, Vec<2>::Zero()), scene.particles);
  scene.put(3, {5.01, 0.5});  // the tank is at x = 5 to 6 m
  lost.before_step(scene.particles);
  scene.take(3);
  lost.after_step(scene.particles, 1);
  EXPECT_THAT(lost.values(), ElementsAre(9, 1, 0, 0, 0, 0));
}

TEST(LostWater, EndsTheRunWhereItIsMoreThanAllowed) {
  Scene scene(0.1);
  LostWater<2> lost(water_from_case<2>(scene.fluid, Vec<2>::Zero()), scene.particles);
  scene.put(1, {1.05, 0.5});
  scene.put(2, {1.05, 0.6});
  lost.before_step(scene.particles);
  scene.take(1);
  EXPECT_NO_THROW(lost.after_step(scene.particles, 0.1));
  lost.before_step(scene.particles);
  scene.take(2);
  try {
    lost.after_step(scene.particles, 0.2);
    FAIL();
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("2 of 10 water particles (20 %) have left the tank by t = 0.2 s: 2 "
                          "at x = 1 m, 0 of them over the rim; fluid.most_lost = 0.1 allows 10 %. "
                          "Make time.window smaller"));
  }
}

TEST(LostWater, IsToldToStayUnderARoofWhereItLeavesOverTheRim) {
  Scene scene(0.1);
  LostWater<2> lost(water_from_case<2>(scene.fluid, Vec<2>::Zero()), scene.particles);
  scene.put(1, {-0.01, 1.2});
  scene.put(2, {0.2, 1.1});
  lost.before_step(scene.particles);
  scene.take(1);
  scene.take(2);
  EXPECT_THAT(
      [&] { lost.after_step(scene.particles, 0.2); },
      ::testing::ThrowsMessage<NumericalError>(HasSubstr("1 at x = 0 m, 1 at y = 1 m, 2 of them over the "
                                                         "rim; fluid.most_lost = 0.1 allows 10 %. Make "
                                                         "the tank higher, or close it")));
}

TEST(LostWater, IsSavedAndRestored) {
  Scene scene;
  LostWater<2> lost(water_from_case<2>(scene.fluid, Vec<2>::Zero()), scene.particles);
  lost.before_step(scene.particles);
  scene.take(0);
  lost.after_step(scene.particles, 0.1);
  StateWriter out;
  lost.save(out);
  const std::string bytes = out.take();
  LostWater<2> other(water_from_case<2>(scene.fluid, Vec<2>::Zero()), Scene().particles);
  StateReader in(bytes);
  other.restore(in);
  EXPECT_EQ(other.values(), lost.values());
}

}  // namespace
}  // namespace cosurge::fluid
