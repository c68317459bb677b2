#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "common/error.hpp"
#include "fluid_solver/mps.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/small_dam_break.hpp"

namespace cosurge::fluid {
namespace {

using test::change_velocities;
using test::down;
using test::plate;
using test::small_dam_break;

TEST(MpsStep, ABodyThatLeavesTheDomainEndsTheRunInWords) {
  auto mps = test::mps_of<2>(small_dam_break(), &plate, down);
  Field displacement = Field::Zero(2, mps.bodies().points());
  displacement.row(0).setConstant(5);
  mps.move_bodies(displacement, Field::Zero(2, mps.bodies().points()));
  EXPECT_THROW((void)mps.step(0, 1e-4), NumericalError);
}

TEST(MpsStep, PressureThatDoesNotConvergeEndsTheRunInWords) {
  v1::Fluid fluid = small_dam_break();
  fluid.mutable_pressure()->set_max_iterations(1);
  fluid.mutable_pressure()->set_tolerance(1e-9);
  auto mps = test::mps_of<2>(fluid, nullptr, down);
  try {
    (void)mps.step(0.25, 1e-3);
    FAIL() << "no error";
  } catch (const NumericalError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("after 1 iterations at t = 0.25 s"), std::string::npos) << what;
    EXPECT_NE(what.find("fluid.pressure.max_iterations"), std::string::npos) << what;
  }
}

TEST(MpsStep, ImpossibleSpeedsEndTheRunInWords) {
  auto mps = test::mps_of<2>(small_dam_break(), nullptr, down);
  change_velocities(mps, [&](Vec<2>& u, const Vec<2>& x) {
    if (x[0] > 0.09 && x[1] > 0.19) u = {0, 1e4};
  });
  EXPECT_THROW((void)mps.step(0, 1e-6), NumericalError);
}

TEST(MpsStep, WaterThatHasAllLeftEndsTheRunInWords) {
  auto mps = test::mps_of<2>(small_dam_break(), nullptr, down);
  change_velocities(mps, [](Vec<2>& u, const Vec<2>&) { u = {0, 20}; });
  try {
    for (int k = 0; k < 10; ++k) (void)mps.step(k * 0.01, 0.01);
    FAIL() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("no water is left"), std::string::npos) << error.what();
  }
}

TEST(MpsStep, OutlinesThatHoldNoParticleAreRefused) {
  v1::Fluid fluid = small_dam_break();
  v1::Shape& speck = *fluid.mutable_water(0);
  speck.Clear();
  for (const double x : {0.101, 0.101, 0.103, 0.101, 0.102, 0.103}) speck.add_vertex(x);
  EXPECT_THROW(test::mps_of<2>(fluid, nullptr, down), Error);
}

TEST(MpsStep, ABodySpeedThatIsNoNumberEndsTheRunInWords) {
  v1::Fluid fluid = small_dam_break();
  fluid.set_source(v1::Fluid::mixed);
  fluid.mutable_water(0)->set_max(0, 0.15);
  auto mps = test::mps_of<2>(fluid, &plate, down);
  const Field velocity = Field::Constant(2, mps.bodies().points(), std::numeric_limits<double>::quiet_NaN());
  mps.move_bodies(Field::Zero(2, mps.bodies().points()), velocity);
  EXPECT_THROW((void)mps.step(0, 1e-4), NumericalError);
}

}  // namespace
}  // namespace cosurge::fluid
