#include "fluid_solver/added_mass.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fluid_solver/mps.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

/// Two points, one mode that moves both: per acceleration -m_a / 2 each.
ModalLoad two_points(double pressure, double added_mass, double mobility) {
  return {.pressure = Eigen::Vector2d::Constant(pressure),
          .per_acceleration = Eigen::MatrixXd::Constant(2, 1, -added_mass / 2),
          .on_modes = Eigen::MatrixXd::Ones(1, 2),
          .mobility = Eigen::VectorXd::Constant(1, mobility),
          .predicted = Eigen::VectorXd::Zero(1)};
}

TEST(ConsistentAccelerations, AreTheLoadOverMassAndAddedMass) {
  // f = 2 p - m_a c and c = f / m: c = 2 p / (m + m_a).
  for (const double added : {0.1, 1.0, 1000.0})
    EXPECT_NEAR(consistent_accelerations(two_points(3, added, 1 / 2.0))[0], 6 / (2 + added), 1e-12);
}

TEST(ConsistentAccelerations, TakeNoSuctionIntoAccount) {
  // The second point would be sucked at: p = max(0, -10 - m_a c / 2) there.
  ModalLoad load = two_points(4, 6, 1 / 2.0);
  load.pressure[1] = -10;
  const double c = consistent_accelerations(load)[0];
  EXPECT_NEAR(c, 4 / (2 + 3.0), 1e-12);  // the first point alone, half of the added mass
}

TEST(ConsistentAccelerations, TakeSuctionIntoAccountDownToTheLowestPressure) {
  ModalLoad load = two_points(4, 6, 1 / 2.0);
  load.pressure[1] = -10;
  load.lowest_pressure = -1e5;
  EXPECT_NEAR(consistent_accelerations(load)[0], (4 - 10) / (2 + 6.0), 1e-12);  // as without a bound
  load.lowest_pressure = -5;  // the second point sucks with 5: c = (4 - 3 c - 5) / 2
  EXPECT_NEAR(consistent_accelerations(load)[0], (4 - 5) / (2 + 3.0), 1e-12);
}

TEST(AddedMassOfAFloor, IsTheMassOfTheColumnAboveAndTheLoadAgreesWithTheAnswer) {
  // Water 0.1 m wide and 0.2 m deep on a body from wall to wall that moves up and down.
  constexpr double l0 = 0.005, mass = 2, rho_h = 20, height = 0.2, sound = 1000;
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.1, 0.3}), {test::box_of({0, 0.02}, {0.1, 0.22})});
  fluid.set_source(v1::Fluid::mixed);
  const v1::Solid floor = test::solid_of(test::box_of({0, 0}, {0.1, 0.02}));
  for (const double dt : {1e-3, 4e-3}) {
    auto mps = test::mps_of<2>(fluid, &floor, Vec<2>(0, -9.81));
    InterfaceMotion motion = InterfaceMotion::at_rest(2, mps.bodies().points());
    InterfaceLoad load = InterfaceLoad::zero(2, mps.bodies().points());
    Field up = Field::Zero(2, mps.bodies().points());
    up.row(1).setOnes();
    const double predicted = -rho_h * 9.81;
    mps.set_modes({{.shape = up, .mobility = dt / mass, .load = predicted}});
    // Predicted: that the floor falls with the water above, under a load as if it did not.
    motion.velocity.row(1).setConstant(-9.81 * dt);
    mps.move_bodies(motion.displacement, motion.velocity);
    (void)mps.step(0, dt);
    // alpha makes the pressure fade over c dt = dt / sqrt(rho alpha): p'' = p / (c dt)^2.
    const double reach = sound * dt;
    const double added = rho_h * reach / height * std::tanh(height / reach);
    // gamma takes 1 %, the operator's reach into the body, where there is no row, 0.8 %; and the pressure
    // belongs to particles half a spacing off: 2.5 % of the height.
    EXPECT_NEAR(mps.added_mass().ratio(), added / mass, 0.05 * added / mass) << dt;
    // The pressure of free fall is zero, so the load is caused by the response alone: f = -m_a c and
    // c = (f - predicted) / m.
    mps.load(load);
    const double found = mass * mps.added_mass().ratio();
    EXPECT_NEAR(load.force.row(1).sum(), predicted * found / (mass + found), 0.01 * std::abs(predicted))
        << dt;
  }
}

TEST(AddedMassOfAFloor, GivesTheLoadOfTheMotionThatItCausesAlsoWhileTheModesPressureIsOld) {
  constexpr double l0 = 0.005, mass = 2, dt = 1e-3, weight = -20 * 9.81;
  v1::Fluid fluid =
      test::tank_of_water(l0, test::box_of({0, 0}, {0.1, 0.3}), {test::box_of({0, 0.02}, {0.1, 0.22})});
  fluid.set_source(v1::Fluid::mixed);
  const v1::Solid floor = test::solid_of(test::box_of({0, 0}, {0.1, 0.02}));
  auto coupled = test::mps_of<2>(fluid, &floor, {0, -9.81});
  auto told = test::mps_of<2>(fluid, &floor, {0, -9.81});
  InterfaceMotion motion = InterfaceMotion::at_rest(2, coupled.bodies().points());
  InterfaceLoad load = InterfaceLoad::zero(2, coupled.bodies().points());
  Field up = Field::Zero(2, coupled.bodies().points());
  up.row(1).setOnes();
  for (int k = 0; k < 6; ++k) {  // the mode's pressure is solved for in the first and the fifth window
    told.restore(coupled.save());
    motion.velocity.row(1).setConstant(0.1 * dt);
    coupled.set_modes({{.shape = up, .mobility = dt / mass, .load = weight}});
    coupled.move_bodies(motion.displacement, motion.velocity);
    (void)coupled.step(k * dt, dt);
    coupled.load(load);
    const double force = load.force.row(1).sum();

    motion.velocity.row(1).array() += dt / mass * (force - weight);
    told.move_bodies(motion.displacement, motion.velocity);
    (void)told.step(k * dt, dt);
    told.load(load);
    // The added mass is ten times the mass and multiplies what is left of the residual, 1e-3.
    EXPECT_NEAR(load.force.row(1).sum(), force, 0.02 * std::abs(weight)) << k;
  }
}

}  // namespace
}  // namespace cosurge::fluid
