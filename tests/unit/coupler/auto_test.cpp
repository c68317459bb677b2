#include "coupler/schemes/auto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/piston_run.hpp"

namespace cosurge {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::Piston;
using testing::PistonRun;

/// Number of iterated windows among at least `count` windows, for a piston with an added mass of `ratio`
/// times its own.
struct AutomaticRun {
  PistonRun piston;
  double iterated = 0;

  AutomaticRun(double ratio, std::size_t count, v1::Coupling::Scheme scheme = v1::Coupling::auto_)
      : piston(piston_of(ratio), words(scheme)) {
    piston.run(count);
    for (const std::vector<double>& own : piston.history.coupling) iterated += own.at(iterations) > 1 ? 1 : 0;
  }
  static constexpr std::size_t iterations = 5;  // among the coupler's columns of a plane scene
  static Piston piston_of(double ratio) {
    return {.mass = 500 / ratio, .stiffness = 100 * (500 + 500 / ratio), .substeps = 20};
  }
  static v1::Coupling words(v1::Coupling::Scheme scheme) {
    v1::Coupling coupling;
    coupling.set_scheme(scheme);
    coupling.set_velocity(v1::Coupling::end);
    return coupling;
  }
};

TEST(AutomaticCoupling, StaysWeakWhereTheWaterIsLight) {
  const AutomaticRun run(0.2, 1000);
  EXPECT_LE(run.iterated, 1000 / Auto::probe_interval + 2);
  EXPECT_TRUE(run.piston.coupler->notes().empty());
}

TEST(AutomaticCoupling, BecomesStrongWhereTheWaterIsHeavyAndSaysWhy) {
  const AutomaticRun run(5, 1000);
  EXPECT_GE(run.iterated, 990);
  EXPECT_THAT(run.piston.coupler->notes(),
              ElementsAre(HasSubstr("coupling scheme changes to strong: velocity-error gain")));
  EXPECT_LT(std::abs(run.piston.history.height.back()), 1);  // it swings by centimetres
}

TEST(AutomaticCoupling, KeepsNothingOfTheWindowsInWhichWeakBecameUnstable) {
  // The water becomes heavy at a certain window; the next probe is up to nine windows later.
  constexpr std::size_t light = 34, all = 60;
  const auto made_heavy = [](v1::Coupling::Scheme scheme) {
    Piston piston = AutomaticRun::piston_of(0.2);
    PistonRun run(piston, AutomaticRun::words(scheme));
    const auto with_light_water = run.solid->on_advance;
    Piston under_heavy_water = AutomaticRun::piston_of(5);
    under_heavy_water.end_velocity = true;
    auto other = testing::sprung_piston(under_heavy_water);
    run.solid->on_advance = [=, &state = run.solid->state, heavy = std::shared_ptr(std::move(other))](
                                const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) {
      if (window.index < light) return with_light_water(window, load, motion);
      heavy->state = state;
      const Report report = heavy->on_advance(window, load, motion);
      state = heavy->state;
      return report;
    };
    run.run(all);
    return run.history.height;
  };
  const auto automatic = made_heavy(v1::Coupling::auto_), strong = made_heavy(v1::Coupling::strong),
             weak = made_heavy(v1::Coupling::weak);
  double swing = 0, automatic_off = 0, weak_off = 0;
  for (std::size_t k = 0; k < all; ++k) {
    swing = std::max(swing, std::abs(strong.at(k)));
    automatic_off = std::max(automatic_off, std::abs(automatic.at(k) - strong.at(k)));
    if (k < light + 6) weak_off = std::max(weak_off, std::abs(weak.at(k) - strong.at(k)));
  }
  EXPECT_LT(automatic_off, 0.05 * swing);  // `weak` lags by a window while the water is light
  EXPECT_GT(weak_off, swing);              // the error grows fivefold in each of six windows
}

TEST(AutomaticCoupling, GoesOnBitForBitFromASavedState) {
  for (const double ratio : {0.2, 5.0}) {
    const AutomaticRun whole(ratio, 60);
    AutomaticRun first(ratio, 30), second(ratio, 0);
    second.piston.coupler->restore(first.piston.coupler->save());
    second.piston.run(30);
    EXPECT_EQ(second.piston.coupler->save(), whole.piston.coupler->save()) << ratio;
  }
}

}  // namespace
}  // namespace cosurge
