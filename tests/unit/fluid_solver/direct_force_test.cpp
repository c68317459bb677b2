// Friction and collisions: what the water loses, walls and bodies get.
#include "fluid_solver/direct_force.hpp"

#include <gtest/gtest.h>

#include "fluid_solver/operators.hpp"
#include "fluid_solver/wall_load.hpp"
#include "tests/support/make_mps.hpp"
#include "tests/support/water.hpp"

namespace cosurge::fluid {
namespace {

/// A disordered block whose left third is a body and whose lowest rows are a wall; all move irregularly.
test::Cloud<2> moving_block() {
  auto cloud = test::block<2>({12, 10}, 1, 0.1);
  Particles<2>& all = cloud.particles;
  for (int i = 0; i < all.size(); ++i) {
    if (all.x[i][0] < 4) all.kind[i] = Kind::body_surface, all.normal[i] = {1, 0};
    if (all.x[i][1] < 2) all.kind[i] = Kind::wall, all.normal[i] = {0, 1};
    all.u[i] = {std::sin(3.0 * i), std::cos(5.0 * i)};
  }
  return cloud;
}

Vec<2> sum(const test::Cloud<2>& cloud, const DirectForce<2>& force) {
  Vec<2> total = Vec<2>::Zero();
  for (int j = 0; j < cloud.particles.size(); ++j) total += force.on(j);
  return total;
}

TEST(DirectForce, OfFrictionIsWhatTheViscosityTakesFromTheWater) {
  auto cloud = moving_block();
  for (int i = 0; i < cloud.particles.size(); ++i) {  // walls that do not rotate, and layers behind the faces
    if (cloud.particles.kind[i] != Kind::fluid) cloud.particles.u[i] = {0.3, 0.5};
    if (cloud.particles.x[i][0] < 3 && cloud.particles.kind[i] == Kind::body_surface)
      cloud.particles.kind[i] = Kind::body_inner;
  }
  cloud.neighbors.rebuild(cloud.particles);
  constexpr double mass = 3, nu = 0.2, n0 = 5, lambda0 = 1.7;
  constexpr double spacing = 1;
  const Vec<2> kick(0.1, -0.2);
  DirectForce<2> force;
  force.clear(cloud.particles.size());
  Vec<2> lost = Vec<2>::Zero();
  for (int i = 0; i < cloud.particles.size(); ++i) {
    if (cloud.particles.kind[i] != Kind::fluid) continue;
    const FaceBefore<2> face = face_before(cloud.particles, cloud.neighbors, i, spacing);
    if (face.place >= 0) force.note_rubbing(i);
    lost -= mass * nu * velocity_laplacian(cloud.particles, cloud.neighbors, i, face, kick, n0, lambda0);
  }
  force.add_friction(cloud.particles, cloud.neighbors, spacing, kick, mass * nu * 2 * 2 / (lambda0 * n0));
  EXPECT_GT(lost.norm(), 1);
  EXPECT_LT((sum(cloud, force) - lost).norm(), 1e-12 * lost.norm());
}

TEST(DirectForce, OfCollisionsIsWhatFacesTakeFromTheWater) {
  auto cloud = moving_block();
  for (int i = 0; i < cloud.particles.size(); ++i)  // water beyond the faces
    if (cloud.particles.kind[i] == Kind::fluid) cloud.particles.x[i] -= Vec<2>(0.8, 0.8);
  constexpr CollisionLaw law{.distance = 0, .restitution = 0, .spacing = 1};  // faces only
  constexpr double mass = 3, dt = 0.01;
  DirectForce<2> force;
  force.clear(cloud.particles.size());
  Vec<2> lost = Vec<2>::Zero();
  for (int i = 0; i < cloud.particles.size(); ++i)
    if (cloud.particles.kind[i] == Kind::fluid)
      lost -= mass / dt * collision(cloud.particles, cloud.neighbors, i, law, [&](int, const Vec<2>&) {
                force.note_struck(i);
              });
  force.add_collisions(cloud.particles, cloud.neighbors, law, mass, dt);
  EXPECT_LT(lost[0], 0) << "towards the body";
  EXPECT_LT(lost[1], 0) << "towards the wall";
  EXPECT_LT((sum(cloud, force) - lost).norm(), 1e-12 * lost.norm());
}

/// Impulse on the floor and momentum of the water, both downwards, for a stream that falls on it, relative to
/// its weight times the time.
struct Fall {
  double impulse;
  double momentum;
};

Fall stream_on_the_floor(double width) {
  constexpr double l0 = 0.01, g = 9.81, end = 0.3;
  v1::Fluid fluid = test::tank_of_water(l0, test::box_of({0, 0}, {1, 0.6}),
                                        {test::box_of({0.5 - width / 2, 0.1}, {0.5 + width / 2, 0.4})});
  fluid.set_kinematic_viscosity(0);
  auto mps = test::mps_of<2>(fluid, nullptr, {0, -g});
  const WallLoad<2> floor(mps, {.on = ProbeMount::On::face, .axis = 1}, {0.5, 0});
  Fall fall{};
  double t = 0;
  for (double dt = mps.first_window(end); t < end;) {
    const StepReport step = mps.step(t, dt);
    t += dt;
    std::vector<std::int32_t> place(static_cast<std::size_t>(mps.initial_size()), 0);
    for (int i = 0; i < mps.particles().size(); ++i) place[mps.particles().id[i]] = i;
    fall.impulse -= dt * floor.read(mps, place, t).force[1];
    dt = step.max_window;
  }
  const double mass = 1000 * l0 * l0, weight = 1000 * width * 0.3 * g;
  for (int i = 0; i < mps.particles().size(); ++i)
    if (mps.particles().kind[i] == Kind::fluid) fall.momentum -= mass * mps.particles().u[i][1];
  fall.impulse /= weight * t;
  fall.momentum /= weight * t;
  return fall;
}

// Seen: 10.8, 3.6 and 2.3 % missing; without the collisions 24, 11 and 4 %. The rest is the pressure gradient
// `corrected`, which is not conservative where a particle lacks neighbours: it becomes smaller with the
// width.
TEST(DirectForce, CarriesTheMomentumOfThinWaterToTheFloor) {
  for (const auto& [width, tolerance] : {std::pair{0.04, 0.14}, {0.08, 0.055}, {0.16, 0.035}}) {
    const Fall fall = stream_on_the_floor(width);
    EXPECT_NEAR(fall.impulse + fall.momentum, 1, tolerance) << width;
    EXPECT_GT(fall.impulse, 0.5) << width;
  }
}

}  // namespace
}  // namespace cosurge::fluid
