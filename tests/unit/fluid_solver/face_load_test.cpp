// Loads belong to the faces of a body, not to the centres of its particles.
#include <gtest/gtest.h>

#include "fluid_solver/mps.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using test::box_of;
using test::solid_of;
using test::tank_of_water;

constexpr double g = 9.81;

/// Load on a body, and the pressures on its faces, as the first step finds them in water at rest.
template <int dim>
InterfaceLoad load_at_rest(const v1::Fluid& fluid, const v1::Solid& solid, const Mps<dim>*& kept,
                           std::unique_ptr<Mps<dim>>& mps) {
  mps = std::make_unique<Mps<dim>>(test::mps_of<dim>(fluid, &solid, -g * Vec<dim>::Unit(dim - 1)));
  (void)mps->step(0, 1e-5);
  InterfaceLoad load = InterfaceLoad::zero(dim, mps->bodies().points());
  mps->load(load);
  kept = mps.get();
  return load;
}

/// Buoyancy of a box of 0.2 m x 0.1 m that sits 0.05 m deep, divided by Archimedes' value.
double buoyancy(int spacings_of_draught) {
  const double l0 = 0.05 / spacings_of_draught;
  v1::Fluid fluid = tank_of_water(
      l0, box_of({0, 0}, {0.6, 0.3}),
      {box_of({0, 0}, {0.2, 0.2}), box_of({0.2, 0}, {0.4, 0.15}), box_of({0.4, 0}, {0.6, 0.2})});
  fluid.mutable_pressure()->set_tolerance(1e-8);
  const v1::Solid solid = solid_of(box_of({0.2, 0.15}, {0.4, 0.25}));
  const Mps<2>* water = nullptr;
  std::unique_ptr<Mps<2>> mps;
  const InterfaceLoad load = load_at_rest<2>(fluid, solid, water, mps);
  EXPECT_NEAR(load.force.row(0).sum(), 0, 1e-3);
  return load.force.row(1).sum() / (1000 * g * 0.2 * 0.05);
}

// First step, on the lattice, whose surface is a quarter of a spacing high (open_surface_test.cpp).
TEST(FaceLoad, BuoyancyIsArchimedes) {
  EXPECT_NEAR(buoyancy(5), 1, 0.06);
  EXPECT_NEAR(buoyancy(10), 1, 0.03);
  EXPECT_NEAR(buoyancy(20), 1, 0.015);
}

TEST(FaceLoad, ASunkBoxIsLiftedByItsVolumeOfWaterWhateverItsShape) {
  const double l0 = 0.01;
  v1::Fluid fluid = tank_of_water(l0, box_of({0, 0}, {0.4, 0.4}), {box_of({0, 0}, {0.4, 0.3})});
  fluid.mutable_pressure()->set_tolerance(1e-8);
  for (const double height : {0.04, 0.08}) {
    const v1::Solid solid = solid_of(box_of({0.16, 0.1}, {0.22, 0.1 + height}));
    const Mps<2>* water = nullptr;
    std::unique_ptr<Mps<2>> mps;
    const InterfaceLoad load = load_at_rest<2>(fluid, solid, water, mps);
    EXPECT_NEAR(load.force.row(1).sum(), 1000 * g * 0.06 * height, 0.01 * 1000 * g * 0.06 * height);
  }
}

TEST(FaceLoad, ThePressureThatAFaceHasIsThatOfItsDepth) {
  const double l0 = 0.01;
  v1::Fluid fluid = tank_of_water(l0, box_of({0, 0}, {0.4, 0.4}), {box_of({0, 0}, {0.4, 0.3})});
  fluid.mutable_pressure()->set_tolerance(1e-8);
  const v1::Solid solid = solid_of(box_of({0.16, 0.1}, {0.22, 0.16}));
  const Mps<2>* water = nullptr;
  std::unique_ptr<Mps<2>> mps;
  const InterfaceLoad load = load_at_rest<2>(fluid, solid, water, mps);
  const Interface interface = water->bodies().interface();
  int faces = 0;
  for (Eigen::Index k = 0; k < interface.points(); ++k) {
    const Vec<2> area = interface.area.col(k);
    if (area[0] != 0 || area[1] == 0) continue;  // top or bottom, away from corners
    ++faces;
    const double face = interface.position(1, k) + (area[1] > 0 ? 0.5 : -0.5) * l0;
    EXPECT_NEAR(load.pressure[k], 1000 * g * (0.3 - face), 0.3 * 1000 * g * l0);
  }
  EXPECT_EQ(faces, 8);
}

TEST(FaceLoad, TurnsWithTheBody) {
  const double l0 = 0.01;
  const auto body = test::bodies_of<2>(solid_of(box_of({0, 0}, {0.05, 0.05})),
                                       {Vec<2>::Constant(-1), Vec<2>::Constant(1)}, l0);
  Mat<2> R;
  R << 0.8, -0.6, 0.6, 0.8;
  Field displacement(2, body.points());
  for (int k = 0; k < body.points(); ++k) displacement.col(k) = R * body.position(k) - body.position(k);
  const Faces<2> still = body.deformed(Field::Zero(2, body.points()));
  const Faces<2> turned = body.deformed(displacement);
  for (int k = 0; k < body.points(); ++k) {
    EXPECT_LT((turned.area[k] - R * still.area[k]).norm(), 1e-12 * l0);
    EXPECT_LT((turned.normal[k] - R * still.normal[k]).norm(), 1e-12);
    EXPECT_LT((turned.spread[k] - R * still.spread[k] * R.transpose()).norm(), 1e-12 * l0);
  }
}

}  // namespace
}  // namespace cosurge::fluid
