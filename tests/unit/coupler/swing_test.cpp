#include "coupler/swing.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/piston_run.hpp"

namespace cosurge {
namespace {

using testing::Piston;
using testing::PistonRun;

/// Judgement of `count` windows of a piston with an added mass of `ratio` times its own, `windows` a period.
std::string judgement(double ratio, v1::Coupling::Velocity velocity, double windows, std::uint64_t count) {
  const Piston piston{.mass = 500 / ratio, .substeps = 50};
  v1::Coupling coupling;
  coupling.set_scheme(v1::Coupling::weak);
  coupling.set_velocity(velocity);
  PistonRun run(piston, coupling, 1 / (windows * piston.wet_frequency()));
  Swing swing(*run.coupler);
  run.coupler->run({&swing}, [&] { return swing.windows() >= count; });
  return swing.judgement();
}

TEST(Swing, TellsAStableRunFromOneWhoseAlternationGrows) {
  EXPECT_EQ(judgement(0.5, v1::Coupling::end, 1000, 1000), "stable");
  EXPECT_EQ(judgement(1.1, v1::Coupling::end, 1000, 200), "growing");  // 1.1 times a window
}

TEST(Swing, TellsALoadThatAlternatesAndGrowsNoMore) {
  // At the limit of `weak` an alternation neither grows nor decays. It starts in the first window, in which
  // the water responds to the motion of the piston for the first time.
  EXPECT_EQ(judgement(0.999, v1::Coupling::end, 20000, 200), "growing");
  EXPECT_EQ(judgement(0.9, v1::Coupling::end, 20000, 200), "stable");  // 0.9^150
}

TEST(Swing, DoesNotTakeNoiseThatGrowsForAnInstability) {
  const Piston piston{.mass = 2500, .substeps = 50};
  v1::Coupling coupling;
  coupling.set_scheme(v1::Coupling::weak);
  coupling.set_velocity(v1::Coupling::end);
  PistonRun run(piston, coupling, 1e-3 / piston.wet_frequency());
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  run.fluid->on_advance = [&, water = run.fluid->on_advance](
                              const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) {
    const Report report = water(window, motion, load);
    load.force.row(1).array() += (window.index < 100 ? 1 : 10) * noise(random);
    return report;
  };
  Swing swing(*run.coupler);
  run.coupler->run({&swing}, [&] { return swing.windows() >= 200; });
  EXPECT_GT(swing.alternation(), 5);
  EXPECT_STREQ(swing.judgement(), "stable");
}

TEST(Swing, TellsARunWhoseEnergyTheSchemeDestroys) {
  // By theory `weak` takes 9 % of the amplitude in a period of 100 windows: nearly all of it in one of 10.
  EXPECT_EQ(judgement(0.5, v1::Coupling::mean, 10, 20), "draining");
  EXPECT_EQ(judgement(0.5, v1::Coupling::mean, 1000, 2000), "stable");
}

}  // namespace
}  // namespace cosurge
