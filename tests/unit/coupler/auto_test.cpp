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

/// Windows that were iterated, among `count`, of a piston with an added mass of `ratio` times its own.
struct AutomaticRun {
  PistonRun piston;
  double iterated = 0;

  AutomaticRun(double ratio, int count) : piston(piston_of(ratio), words()) {
    for (int k = 0; k < count; ++k) {
      piston.run(1);
      iterated += piston.value("iterations") > 1 ? 1 : 0;
    }
  }
  static Piston piston_of(double ratio) {
    return {.mass = 500 / ratio, .stiffness = 100 * (500 + 500 / ratio), .substeps = 20};
  }
  static v1::Coupling words() {
    v1::Coupling coupling;
    coupling.set_scheme(v1::Coupling::auto_);
    coupling.set_velocity(v1::Coupling::end);
    return coupling;
  }
};

TEST(AutomaticCoupling, StaysWeakWhereTheWaterIsLight) {
  const AutomaticRun run(0.2, 1000);
  EXPECT_LE(run.iterated, 1000 / Auto::probe_interval + 1);
  EXPECT_TRUE(run.piston.coupler->notes().empty());
}

TEST(AutomaticCoupling, BecomesStrongWhereTheWaterIsHeavyAndSaysWhy) {
  const AutomaticRun run(5, 1000);
  EXPECT_GE(run.iterated, 990);
  EXPECT_THAT(run.piston.coupler->notes(),
              ElementsAre(HasSubstr("strong from here: an error of the velocity")));
  EXPECT_LT(std::abs(run.piston.history.height.back()), 1);  // it swings by centimetres
}

TEST(AutomaticCoupling, GoesOnBitForBitFromASavedState) {
  const AutomaticRun whole(5, 60);
  AutomaticRun first(5, 30), second(5, 0);
  second.piston.coupler->restore(first.piston.coupler->save());
  second.piston.run(30);
  EXPECT_EQ(second.piston.coupler->save(), whole.piston.coupler->save());
}

}  // namespace
}  // namespace cosurge
