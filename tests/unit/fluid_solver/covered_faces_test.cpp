// Faces that a body shares with obstacles and other bodies carry no pressure of water.
#include "fluid_solver/covered_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fluid_solver/mps.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

using test::box_of;

constexpr double l0 = 0.01, g = 9.81;

/// Load along x on each body after a step.
std::vector<double> loads(const v1::Fluid& fluid, const v1::Solid& solid) {
  auto mps = test::mps_of<2>(fluid, &solid, {0, -g});
  const int points = mps.bodies().points();
  (void)mps.step(0, 1e-5);
  InterfaceLoad load = InterfaceLoad::zero(2, points);
  mps.load(load);
  std::vector<double> sums(static_cast<std::size_t>(solid.body_size()), 0.0);
  for (int k = 0; k < points; ++k) sums[static_cast<std::size_t>(mps.bodies().body(k))] += load.force(0, k);
  return sums;
}

/// A plate from 0.3 to 0.34 m with water 0.1 m deep on its left.
v1::Solid plate() { return test::solid_of(box_of({0.3, 0}, {0.34, 0.2}), {box_of({0.3, -0.04}, {0.34, 0})}); }
v1::Fluid water_on_the_left(const std::vector<v1::Box>& more = {}) {
  std::vector<v1::Box> water = {box_of({0, 0}, {0.3, 0.1})};
  water.insert(water.end(), more.begin(), more.end());
  v1::Fluid fluid = test::tank_of_water(l0, box_of({0, 0}, {0.6, 0.4}), water);
  fluid.mutable_pressure()->set_tolerance(1e-8);
  return fluid;
}
void add_block(v1::Fluid& fluid, double left) {
  *fluid.add_obstacle()->mutable_shape() = shape_of(box_of({left, 0}, {left + 0.1, 0.2}));
}

TEST(CoveredFaces, AnObstacleBehindAPlateChangesNothing) {
  const double alone = loads(water_on_the_left(), plate())[0];
  EXPECT_NEAR(alone, 0.5 * 1000 * g * 0.1 * 0.1, 0.1 * 49);
  v1::Fluid fluid = water_on_the_left();
  add_block(fluid, 0.34);
  EXPECT_NEAR(loads(fluid, plate())[0], alone, 0.02 * alone);  // it was -30 N/m
}

TEST(CoveredFaces, TwoDryPlatesDoNotPushEachOther) {
  v1::Solid solid = plate();
  *solid.add_body() = plate().body(0);
  v1::Body& second = *solid.mutable_body(1);
  for (v1::Box* box : {second.mutable_box()}) *box = box_of({0.34, 0}, {0.38, 0.2});
  *second.mutable_clamp(0) = shape_of(box_of({0.34, -0.04}, {0.38, 0}));
  v1::Fluid fluid = test::tank_of_water(l0, box_of({0, 0}, {0.6, 0.4}), {box_of({0, 0}, {0.1, 0.1})});
  fluid.mutable_pressure()->set_tolerance(1e-8);
  for (const double load : loads(fluid, solid)) EXPECT_NEAR(load, 0, 0.1);
}

TEST(CoveredFaces, CloseAsAPlateComesToAnObstacle) {
  const v1::Solid solid = plate();
  v1::Fluid fluid = water_on_the_left();
  add_block(fluid, 0.36);
  auto mps = test::mps_of<2>(fluid, &solid, {0, -g});
  const auto wet_points = [&](double gap) {
    const int points = mps.bodies().points();
    mps.move_bodies(Vec<2>(0.02 - gap, 0).replicate(1, points), Field::Zero(2, points));
    (void)mps.step(0, 1e-6);
    double open = 0;
    for (int i = 0; i < mps.particles().size(); ++i)
      open += mps.particles().kind[i] == Kind::body_surface ? 1 : 0;
    return open;
  };
  const double apart = wet_points(0.6 * l0);
  EXPECT_EQ(wet_points(0.3 * l0), apart);
  EXPECT_EQ(wet_points(0), apart - 19);  // the uppermost of 20 points has an open upper face
  EXPECT_EQ(wet_points(0.6 * l0), apart);
}

/// Open faces towards +x of a body beside a wall at a distance, with or without water between them, where the
/// faces were open before as `covered` knows.
double open_to_the_right(CoveredFaces<2>& covered, double gap, bool water) {
  const auto bodies =
      test::bodies_of<2>(test::solid_of(box_of({0, 0}, {0.04, 0.08})), Box<2>({-1, -1}, {1, 1}), l0);
  Particles<2> particles;
  std::vector<Vec<2>> wall = fill(Box<2>({0.04, 0}, {0.07, 0.08}), l0);
  for (const Vec<2>& x : wall) particles.add(Kind::dummy, x + Vec<2>(gap, 0));
  for (double y = 0.5 * l0; water && y < 0.08; y += l0) particles.add(Kind::fluid, {0.045, y});
  const int first = particles.size();
  for (int k = 0; k < bodies.points(); ++k)
    particles.add(bodies.wet(k) ? Kind::body_surface : Kind::body_inner, bodies.position(k));
  Neighbors<2> neighbors(Box<2>({-1, -1}, {1, 1}), 2.1 * l0);
  neighbors.rebuild(particles);
  std::vector<int> place(static_cast<std::size_t>(bodies.points()));
  for (int i = 0; i < particles.size(); ++i)
    if (particles.id[i] >= first) place[static_cast<std::size_t>(particles.id[i] - first)] = i;
  const Faces<2> faces = bodies.deformed(Field::Zero(2, bodies.points()));
  const auto open = covered.find(bodies, faces, place, particles, neighbors, l0);
  double sum = 0;
  for (int k = 0; k < bodies.points(); ++k)
    sum += bodies.lattice_faces(k).above[0] / l0 * open[static_cast<std::size_t>(k)].above[0];
  return sum;
}

TEST(CoveredFaces, CloseInTheDryWithTheGapAndOpenAgain) {
  CoveredFaces<2> covered;
  for (const auto& [gap, open] :
       {std::pair(1.2, 8.0), {0.6, 8.0}, {0.375, 4.0}, {0.2, 0.0}, {0.0, 0.0}, {0.5, 8.0}})
    EXPECT_NEAR(open_to_the_right(covered, gap * l0, false), open, 1e-9) << gap;
}

TEST(CoveredFaces, AFilmIsLeftWhereWaterIsSqueezedOut) {
  CoveredFaces<2> covered;
  const auto films = [&] { return std::count(covered.film().begin(), covered.film().end(), 1); };
  EXPECT_EQ(open_to_the_right(covered, 1.2 * l0, true), 8);
  const auto whole = films();
  EXPECT_GE(whole, 8);
  for (const double gap : {0.9, 0.4, 0.0, 0.4}) {
    (void)open_to_the_right(covered, gap * l0, false);
    EXPECT_EQ(films(), 8) << gap;
  }
  // In the air it is gone.
  EXPECT_EQ(open_to_the_right(covered, 1.2 * l0, false), 8);
  EXPECT_EQ(films(), 0);
}

// A block with water on all sides comes down on an obstacle: whatever the gap, it keeps its buoyancy, exactly
// up to the error of the hydrostatic pressure (1 %) on both faces.
TEST(FilmPressure, CarriesABlockOnAnObstacleByItsBuoyancy) {
  const v1::Solid solid = test::solid_of(box_of({0.2, 0.1}, {0.3, 0.14}));
  v1::Fluid fluid = test::tank_of_water(l0, box_of({0, 0}, {0.5, 0.4}), {box_of({0, 0}, {0.5, 0.3})});
  *fluid.add_obstacle()->mutable_shape() = shape_of(box_of({0.15, 0}, {0.35, 0.08}));
  auto mps = test::mps_of<2>(fluid, &solid, {0, -g});
  const int points = mps.bodies().points();
  double t = 0;
  const auto lift = [&](double from, double to, int steps) {
    constexpr double dt = 1e-3;
    double mean = 0;
    for (int k = 0; k < steps; ++k) {
      const double down = from + (to - from) * (k + 1) / steps, speed = (to - from) / (steps * dt);
      mps.move_bodies(Vec<2>(0, -down).replicate(1, points), Vec<2>(0, -speed).replicate(1, points));
      (void)mps.step(t, dt);
      t += dt;
      InterfaceLoad load = InterfaceLoad::zero(2, points);
      mps.load(load);
      mean += load.force.row(1).sum() / steps;
    }
    return mean;
  };
  const double buoyancy = 1000 * g * 0.1 * 0.04;
  double last = 0;
  for (const double gap : {0.1, 0.0}) {
    const double down = 0.02 - gap * l0;
    (void)lift(last, down, 200);
    (void)lift(down, down, 100);
    EXPECT_NEAR(lift(down, down, 200), buoyancy, 0.1 * buoyancy) << gap;
    last = down;
  }
}

}  // namespace
}  // namespace cosurge::fluid
