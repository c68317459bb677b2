#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/threads.hpp"
#include "fluid_solver/mps.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/small_dam_break.hpp"

namespace cosurge::fluid {
namespace {

using test::box_of;
using test::down;
using test::l0;
using test::plate;
using test::small_dam_break;
using test::tank_of_water;

TEST(MpsState, ContinuesBitForBitInAFreshObject) {
  auto whole = test::mps_of<2>(small_dam_break(), &plate, down);
  auto fresh = test::mps_of<2>(small_dam_break(), &plate, down);
  constexpr double dt = 1e-3;
  for (int k = 0; k < 20; ++k) (void)whole.step(k * dt, dt);
  fresh.restore(whole.save());
  EXPECT_EQ(fresh.save(), whole.save());
  InterfaceLoad a = InterfaceLoad::zero(2, whole.bodies().points());
  InterfaceLoad b = a;
  for (int k = 20; k < 40; ++k) {
    const StepReport one = whole.step(k * dt, dt);
    const StepReport other = fresh.step(k * dt, dt);
    EXPECT_EQ(one.max_window, other.max_window);
    EXPECT_EQ(one.pressure.iterations, other.pressure.iterations);
  }
  whole.load(a);
  fresh.load(b);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(fresh.save(), whole.save());
  EXPECT_NE(whole.save(), test::mps_of<2>(small_dam_break(), &plate, down).save());  // something happened
}

/// The state begins with places, velocities, pressures and so on, each with its length before it.
TEST(MpsState, WithAnIdTwiceOrOutOfRangeOrAWrongLengthIsRefused) {
  auto mps = test::mps_of<2>(small_dam_break(), &plate, down);
  const std::string good = mps.save();
  const auto skip = [&](std::size_t at, std::size_t size_of_entry) {
    std::uint64_t count = 0;
    std::memcpy(&count, good.data() + at, sizeof count);
    return at + sizeof count + count * size_of_entry;
  };
  std::size_t ids = 0;
  for (const std::size_t size :
       {sizeof(Vec<2>), sizeof(Vec<2>), sizeof(double), sizeof(double), sizeof(Vec<2>), sizeof(Kind)})
    ids = skip(ids, size);
  const std::size_t first = ids + sizeof(std::uint64_t);
  std::int32_t second_id = 0;
  std::memcpy(&second_id, good.data() + first + sizeof second_id, sizeof second_id);
  for (const std::int32_t id : {-1, mps.initial_size(), 1 << 30, second_id}) {
    std::string bad = good;
    std::memcpy(bad.data() + first, &id, sizeof id);
    EXPECT_THROW(mps.restore(bad), Error) << id;
  }
  std::string shorter = good;  // one id less
  std::uint64_t count = 0;
  std::memcpy(&count, good.data() + ids, sizeof count);
  --count;
  std::memcpy(shorter.data() + ids, &count, sizeof count);
  shorter.erase(first, sizeof second_id);
  EXPECT_THROW(mps.restore(shorter), Error);
  std::string endless = good;
  const double infinite = std::numeric_limits<double>::infinity();
  std::memcpy(endless.data() + sizeof(std::uint64_t), &infinite, sizeof infinite);
  EXPECT_THROW(mps.restore(endless), Error);
  EXPECT_NO_THROW(mps.restore(good));
}

/// Water on both sides of a plate, with the mixed source, whose pressure answers the plate's velocity.
Mps<2> water_beside_a_plate() {
  v1::Fluid fluid = tank_of_water(l0, box_of({0, 0}, {0.3, 0.3}),
                                  {box_of({0, 0}, {0.15, 0.1}), box_of({0.18, 0}, {0.3, 0.1})});
  fluid.set_source(v1::Fluid::mixed);
  return test::mps_of<2>(fluid, &plate, down);
}

struct LoadedStep {
  InterfaceLoad load;
  std::string state;
};

/// The step after two others, gone through once for each velocity of the plate to the right [m/s].
LoadedStep last_of_attempts(const std::vector<double>& velocities) {
  constexpr double dt = 1e-3;
  Mps<2> mps = water_beside_a_plate();
  for (int k = 0; k < 2; ++k) (void)mps.step(k * dt, dt);
  InterfaceMotion motion = InterfaceMotion::at_rest(2, mps.bodies().points());
  InterfaceLoad load = InterfaceLoad::zero(2, mps.bodies().points());
  Attempt attempt = Attempt::first;
  for (const double velocity : velocities) {
    motion.velocity.row(0).setConstant(velocity);
    attempt == Attempt::first ? mps.move_bodies(motion.displacement, motion.velocity)
                              : mps.set_body_velocity(motion.velocity);
    (void)mps.step(2 * dt, dt, attempt);
    attempt = Attempt::again;
  }
  mps.load(load);
  return {load, mps.save()};
}

TEST(MpsAttempts, WithTheSameVelocityGiveTheSameBits) {
  const LoadedStep once = last_of_attempts({0.01});
  const LoadedStep thrice = last_of_attempts({0.01, 0.01, 0.01});
  EXPECT_GT(once.load.pressure.maxCoeff(), 0);
  EXPECT_EQ(once.load.force, thrice.load.force);
  EXPECT_EQ(once.state, thrice.state);
}

TEST(MpsAttempts, ForgetTheVelocityOfTheAttemptBefore) {
  const LoadedStep once = last_of_attempts({0.01});
  const LoadedStep again = last_of_attempts({0.5, 0.01});
  const LoadedStep other = last_of_attempts({0.5});
  const auto difference = [&](const LoadedStep& a, const LoadedStep& b) {
    return (a.load.force - b.load.force).norm() / b.load.force.norm();
  };
  EXPECT_GT(difference(other, once), 0.1);
  // The residual of the pressure equation is 1e-4 of the right-hand side; the water is 10 particles deep, so
  // that the inverse magnifies it by about ten.
  EXPECT_LT(difference(again, once), 2e-3);
}

TEST(MpsState, TruncatedBytesAreRefused) {
  auto mps = test::mps_of<2>(small_dam_break(), nullptr, down);
  const std::string state = mps.save();
  EXPECT_ANY_THROW(mps.restore(state.substr(0, state.size() - 1)));
  EXPECT_ANY_THROW(mps.restore(state + "x"));
}

TEST(MpsStep, GivesTheSameBitsForAnyNumberOfThreads) {
  // 5400 fluid particles: every loop with a threshold runs in parallel.
  v1::Fluid fluid = tank_of_water(0.002, box_of({0, 0}, {0.3, 0.3}), {box_of({0, 0}, {0.12, 0.18})});
  fluid.set_source(v1::Fluid::mixed);
  std::string first;
  for (const int threads : {1, 2, 4}) {
    set_threads(threads);
    auto mps = test::mps_of<2>(fluid, &plate, down);
    for (int k = 0; k < 5; ++k) (void)mps.step(k * 2e-4, 2e-4);
    if (first.empty()) first = mps.save();
    EXPECT_EQ(mps.save() == first, true) << threads;
  }
}

}  // namespace
}  // namespace cosurge::fluid
