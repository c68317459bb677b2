#include "fluid_solver/gauges.hpp"

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "fluid_solver/snap_to_face.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

constexpr double l0 = 0.01;
constexpr double rho_g = 9810;

/// Water 0.1 m deep at rest in a tank of 0.3 m, with the pressure rho g (0.1 m - y) + slope x on everything
/// that has one, and the water's particles moved by up to `disorder` spacings.
Mps<2> still_water(double disorder, double slope) {
  auto mps = test::mps_of<2>(
      test::tank_of_water(l0, test::box_of({0, 0}, {0.3, 0.3}), {test::box_of({0, 0}, {0.3, 0.1})}), nullptr,
      {0, -9.81});
  Particles<2> particles = mps.particles();
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-disorder * l0, disorder * l0);
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] == Kind::fluid) particles.x[i] += Vec<2>(shift(random), shift(random));
    particles.p[i] = rho_g * (0.1 - particles.x[i][1]) + slope * particles.x[i][0];
  }
  // The state begins with places, velocities and pressures.
  StateWriter head;
  head.put(mps.particles().x);
  head.put(mps.particles().u);
  head.put(mps.particles().p);
  StateWriter fresh;
  fresh.put(particles.x);
  fresh.put(particles.u);
  fresh.put(particles.p);
  mps.restore(fresh.take() + mps.save().substr(head.take().size()));
  return mps;
}

TEST(PressureGauge, IsExactForALinearPressureInDisorderAndOnWalls) {
  const Mps<2> mps = still_water(0.1, 2000);
  for (const Vec<2>& x : {Vec<2>(0.15, 0.05), Vec<2>(0.203, 0.033), Vec<2>(0, 0.04), Vec<2>(0.1, 0)})
    EXPECT_NEAR(pressure_at(mps, x), rho_g * (0.1 - x[1]) + 2000 * x[0], 1e-8) << x.transpose();
}

TEST(PressureGauge, IsZeroInTheDryAndOutside) {
  const Mps<2> mps = still_water(0, 0);
  EXPECT_EQ(pressure_at(mps, {0.15, 0.25}), 0);
  EXPECT_EQ(pressure_at(mps, {5, 5}), 0);
}

TEST(SnapToFace, FindsTheNearestPointOfTheWetFaces) {
  // A plate of 4 x 8 sites on the floor: its left, right and upper faces are wet.
  const auto bodies = test::bodies_of<2>(test::solid_of(test::box_of({0.1, 0}, {0.14, 0.08})),
                                         Box<2>({0, 0}, {0.3, 0.3}), l0);
  const Interface interface = bodies.interface();
  const auto snapped = [&](const Vec<2>& x) { return snap_to_face<2>("p", x, interface, l0); };
  const std::vector<std::pair<Vec<2>, Vec<2>>> points = {
      {{0.1, 0.033}, {0.1, 0.033}},    // on a face
      {{0.104, 0.033}, {0.1, 0.033}},  // behind it
      {{0.092, 0.033}, {0.1, 0.033}},  // before it
      {{0.12, 0.077}, {0.12, 0.08}},  {{0.145, 0.084}, {0.14, 0.08}}, {{0.103, -0.004}, {0.1, 0}}};
  for (const auto& [x, face] : points) EXPECT_LT((snapped(x) - face).norm(), 1e-12) << x.transpose();
}

TEST(SnapToFace, NamesTheNearestFaceWhereItIsFartherThanASpacing) {
  const auto bodies = test::bodies_of<2>(test::solid_of(test::box_of({0.1, 0}, {0.14, 0.08})),
                                         Box<2>({0, 0}, {0.3, 0.3}), l0);
  try {
    snap_to_face<2>("middle", {0.118, 0.04}, bodies.interface(), l0);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "output.probe middle: the nearest wet face of a body is 0.018 m away, at (0.1, 0.04), and a "
                 "spacing is 0.01 m: move the probe there");
  }
}

TEST(SurfacePressureProbe, InterpolatesAlongTheFaceAndSeesNoOther) {
  // A plate of 4 x 8 sites; pressure linear along its left face, 1e9 elsewhere.
  const auto bodies = test::bodies_of<2>(test::solid_of(test::box_of({0.1, 0}, {0.14, 0.08})),
                                         Box<2>({0, 0}, {0.3, 0.3}), l0);
  const Interface interface = bodies.interface();
  Eigen::VectorXd pressure(interface.points());
  for (Eigen::Index k = 0; k < interface.points(); ++k)
    pressure[k] = interface.position(0, k) < 0.106 ? 1000 + 5000 * interface.position(1, k) : 1e9;
  for (const double y : {0.005, 0.0123, 0.047, 0.075})
    EXPECT_NEAR(SurfacePressureProbe<2>("P", {0.1, y}, interface, l0).read(pressure), 1000 + 5000 * y, 1e-9)
        << y;
  EXPECT_NEAR(SurfacePressureProbe<2>("P", {0.1, 0}, interface, l0).read(pressure), 1000 + 5000 * 0.005,
              1e-9);
  EXPECT_THROW(SurfacePressureProbe<2>("P", {0.12, 0.04}, interface, l0), Error);
}

TEST(WaterSurvey, TheFrontIsOfWaterThatHangsTogether) {
  const auto mps = test::mps_of<2>(
      test::tank_of_water(l0, test::box_of({0, 0}, {0.3, 0.3}),
                          {test::box_of({0, 0}, {0.1, 0.1}), test::box_of({0.2, 0}, {0.21, 0.01})}),
      nullptr, {0, -9.81});
  const WaterState state = survey_water<2>(mps, 0.1, l0, {0, -9.81});
  EXPECT_NEAR(state.front, 0.1, 1e-12);
  EXPECT_EQ(state.kinetic_energy, 0);
  // 100 particles of 0.1 kg at 0.05 m, and one at 0.005 m.
  EXPECT_NEAR(state.gravity_energy, 9.81 * (100 * 0.1 * 0.05 + 0.1 * 0.005), 1e-12);
}

}  // namespace
}  // namespace cosurge::fluid
