// Contact: momentum, energy and messages, for every model in two and three dimensions.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>

#include "tests/support/contact_scene.hpp"

namespace cosurge {
namespace {

using test::ContactRun;
using test::ContactScene;
using testing::Combine;
using testing::Values;
using Word = v1::SolidModel;

constexpr double g = 9.81;
constexpr double dt = ContactScene::window;

// Tolerance as a share of the energy of a blow. The springs' forces are constant within a sub-step; 12
// sub-steps are a period of the fastest motion that the springs cause. If a vertex begins or ceases to touch
// within a sub-step, the error is of order (omega dt)^2 with omega dt = 0.5; over several vertices it
// averages out. Largest error here: 3.5 % (`mps`, the block that falls), 0.9 % for a rigid block.
constexpr double of_a_blow = 0.04;

/// Tolerance for the model's own energy account, as a share of the same energy. `mps` and `hamiltonian` have
/// a ripple of (omega dt)^2 from their explicit steps, for waves that the blow excites; `mps` also takes the
/// kinetic energy at the end of a sub-step with the force at its start (3.3 % within a blow); `fem` has the
/// midpoint rule's error in large deformation; the others have rounding.
double of_the_model(Word::Word model) {
  switch (model) {
    case Word::mps:
      return 0.04;
    case Word::hamiltonian:
      return 0.006;
    case Word::fem:
      return 1e-3;
    default:
      return 1e-9;
  }
}

std::string title(Word::Word model, int dimension) {
  return Word::Word_Name(model) + "_" + std::to_string(dimension) + "d";
}

class Contact : public testing::TestWithParam<std::tuple<Word::Word, int>> {
 protected:
  Word::Word model() const { return std::get<0>(GetParam()); }
  int dimension() const { return std::get<1>(GetParam()); }
  std::string up(const std::string& name) const { return name + (dimension() == 2 ? "_y" : "_z"); }

  /// Energies after every window, over the energy of the blow.
  void expect_accounts(const ContactRun& run, double energy) const {
    ASSERT_LT(std::abs(run.unaccounted()), of_the_model(model()) * energy) << run.windows;
    ASSERT_LT(std::abs(run.made_by_contact()), of_a_blow * energy) << run.windows;
  }
};

TEST_P(Contact, ABlockThatFallsBouncesAndItsMomentumIsWhatFloorAndWeightGive) {
  const double height = 0.01;
  ContactScene scene(model(), dimension());
  scene.gravity(0, -g);
  scene.add_block(0.1, height, 0.06, 0.04);
  ContactRun run(scene.the_case);
  const double mass = ContactScene::density * 0.06 * 0.04 * scene.depth(), energy = mass * g * height;
  double impulse = 0, before = 0, now = 0, deepest = 0;
  while (run.windows < 90) {
    run.advance();
    expect_accounts(run, energy);
    impulse += run.value(up("contact_load")) * dt;
    before = now;
    now = run.value("gravity_energy") / (mass * g);  // height of the centre
    deepest = std::min(deepest, now);
  }
  EXPECT_EQ(run.value("contact_points"), 0);
  EXPECT_GT(now, -0.5 * height);                              // it has bounced, and is in the air again
  EXPECT_GT(deepest, -height - 0.3 * ContactScene::spacing);  // its face by v / omega, and it bends
  const double speed = (now - before) / dt - 0.5 * g * dt;
  // Exact but for rounding, and the half sub-step by which velocities of `mps` are behind.
  const double tolerance = model() == Word::mps ? mass * g * run.setup.substep : 1e-6 * mass * g;
  EXPECT_NEAR(impulse, mass * (g * run.time + speed), tolerance);
  ASSERT_EQ(run.notes.size(), 1u);
  EXPECT_NE(run.notes[0].find("solid.body.0 touches the floor of the tank, near (0.1"), std::string::npos)
      << run.notes[0];
}

TEST_P(Contact, ABlockThatStandsOnTheFloorIsCarriedByItsWeight) {
  ContactScene scene(model(), dimension());
  scene.gravity(0, -g);
  scene.add_block(0.1, 0, 0.06, 0.04);
  ContactRun run(scene.the_case);
  const double mass = ContactScene::density * 0.06 * 0.04 * scene.depth();
  double impulse = 0, lowest = 0;
  while (run.windows < 200) {
    run.advance();
    impulse += run.value(up("contact_load")) * dt;
    lowest = std::min(lowest, run.value("gravity_energy") / (mass * g));
  }
  // Remaining momentum: |p| <= sqrt(2 m E), and the sub-step of `mps`.
  const double momentum = std::sqrt(2 * mass * run.value("kinetic_energy")) + mass * g * run.setup.substep;
  EXPECT_NEAR(impulse, mass * g * run.time, momentum + 1e-9 * impulse);
  EXPECT_LT(momentum, 0.02 * mass * g * run.time);
  EXPECT_GT(lowest,
            -0.02 * ContactScene::spacing);  // 0.1 mm of its own weight's compression, and the springs
}

TEST_P(Contact, TwoBlocksThatCollideKeepTheirMomentum) {
  const double pull = 1, push = 20;  // m/s2 on both; on the first one for 20 ms
  ContactScene scene(model(), dimension());
  scene.gravity(pull, 0);
  scene.add_block(0.10, 0.1, 0.05, 0.04);
  scene.add_block(0.16, 0.1, 0.05, 0.04);
  ContactRun run(scene.the_case, scene.points());
  const double mass = ContactScene::density * 0.05 * 0.04 * scene.depth(), speed = 0.02 * push;
  const auto points = static_cast<double>(run.interface.points());
  const double blow = 0.25 * mass * speed * speed;  // the energy of the motion against each other
  while (run.windows < 70) {
    run.load.force.row(0).setConstant(run.windows < 20 ? mass * push / points : 0);
    run.advance();
    expect_accounts(run, blow);
    EXPECT_EQ(run.value("contact_load_x"), 0);  // nothing from outside
    // The centre of both, as if they did not touch.
    const double t = run.time, t1 = std::min(t, 0.02);
    const double way = 0.5 * pull * t * t + 0.5 * push * (0.5 * t1 * t1 + t1 * (t - t1));
    const double tolerance = model() == Word::mps ? (pull + push) * t * run.setup.substep : 1e-9;
    ASSERT_NEAR(-run.value("gravity_energy") / (2 * mass * pull), way, tolerance) << run.windows;
  }
  EXPECT_EQ(run.value("contact_points"), 0);
  EXPECT_GT(run.value("contact_work"), -of_a_blow * blow);
  ASSERT_EQ(run.notes.size(), 1u);
  EXPECT_NE(run.notes[0].find("solid.body.0 touches solid.body.1"), std::string::npos) << run.notes[0];
}

TEST_P(Contact, AWedgeThatLandsOnABeachIsPushedAlongItsNormal) {
  ContactScene scene(model(), dimension());
  scene.gravity(0, -g);
  *scene.the_case.mutable_fluid()->add_obstacle()->mutable_shape() =
      scene.outline({{0.1, 0}, {0.4, 0}, {0.4, 0.15}}, 0, 0.4);  // one in two
  *scene.the_case.mutable_solid()->add_body()->mutable_shape() =
      scene.outline({{0.2, 0.06}, {0.3, 0.11}, {0.3, 0.15}, {0.2, 0.15}});
  ContactRun run(scene.the_case);
  const double mass = ContactScene::density * 0.5 * (0.09 + 0.04) * 0.1 * scene.depth();
  double along = 0, normal = 0;
  while (run.windows < 90) {
    run.advance();
    expect_accounts(run, mass * g * 0.01);
    along += run.value("contact_load_x") * dt;
    normal += run.value(up("contact_load")) * dt;
  }
  EXPECT_GT(normal, mass * std::sqrt(2 * g * 0.01));  // it lost at least the fall's momentum
  // A rigid body's faces keep their direction; others turn by some degrees, as the push is beside the centre.
  EXPECT_NEAR(along / normal, -0.5, model() == Word::sprung ? 1e-6 : 0.05);
  ASSERT_EQ(run.notes.size(), 1u);
  EXPECT_NE(run.notes[0].find("solid.body.0 touches fluid.obstacle.0"), std::string::npos) << run.notes[0];
}

TEST_P(Contact, AnObstacleThatComesPushesABlockAwayAtTwiceItsSpeed) {
  ContactScene scene(model(), dimension());
  scene.gravity(1e-9, 0);  // tiny, so that gravity_energy gives the position of the block
  v1::Obstacle& obstacle = *scene.the_case.mutable_fluid()->add_obstacle();
  *obstacle.mutable_shape() =
      scene.outline({{0.02, 0.06}, {0.08, 0.06}, {0.08, 0.18}, {0.02, 0.18}}, 0.06, 0.18);
  v1::WallMotion& motion = *obstacle.mutable_motion();
  const double speed = 0.2;
  for (const double t : {0.0, 0.5})
    for (const double value : dimension() == 2 ? std::vector<double>{t, speed * t, 0, 0}
                                               : std::vector<double>{t, speed * t, 0, 0, 0})
      motion.add_row(value);
  scene.add_block(0.09, 0.1, 0.05, 0.04);
  ContactRun run(scene.the_case);
  const double mass = ContactScene::density * 0.05 * 0.04 * scene.depth();
  double impulse = 0;
  while (run.windows < 90) {
    run.advance();
    impulse += run.value("contact_load_x") * dt;
    ASSERT_LT(std::abs(run.unaccounted()), of_the_model(model()) * 2 * mass * speed * speed) << run.windows;
  }
  EXPECT_EQ(run.value("contact_points"), 0);
  // A rigid block leaves at 2 v but for what a blow may lose; in an elastic one waves keep a part of the
  // energy.
  const double restitution = impulse / (mass * speed) - 1;
  EXPECT_LT(restitution, 1 + of_a_blow);
  EXPECT_GT(restitution, model() == Word::sprung ? 1 - of_a_blow : 0.7);
  EXPECT_EQ(run.notes.size(), 1u);
}

TEST_P(Contact, ARunThatGoesOnFromWithinABlowHasTheSameBits) {
  ContactScene scene(model(), dimension());
  scene.gravity(0, -g);
  scene.add_block(0.1, 0.01, 0.06, 0.04);
  ContactRun whole(scene.the_case), second(scene.the_case);
  std::string state;
  while (whole.windows < 60) {
    whole.advance();
    if (whole.windows != 46) continue;
    state = whole.solid.save();
    ASSERT_GT(whole.value("contact_points"), 0);
  }
  second.solid.restore(state);
  second.time = 46 * dt;
  second.windows = 46;
  while (second.windows < 60) second.advance();
  EXPECT_EQ(second.notes.size(), 0u);  // the touch has been told
  for (const char* name :
       {"kinetic_energy", "elastic_energy", "gravity_energy", "contact_energy", "contact_work"})
    EXPECT_EQ(whole.value(name), second.value(name)) << name;
}

INSTANTIATE_TEST_SUITE_P(AllModels, Contact,
                         Combine(Values(Word::mps, Word::hamiltonian, Word::fem, Word::modal, Word::sprung),
                                 Values(2, 3)),
                         [](const auto& scene) {
                           return title(std::get<0>(scene.param), std::get<1>(scene.param));
                         });

/// A plate of three spacings on the floor beside a wall.
class Slap : public Contact {
 protected:
  ContactScene scene() const {
    ContactScene made(model(), dimension());
    made.gravity(0, 0);
    v1::Body& plate = made.add_block(0.1, 0, 0.03, 0.12);
    v1::Shape& clamp = *plate.add_clamp();
    *clamp.mutable_min() = plate.box().min();
    *clamp.mutable_max() = plate.box().max();
    clamp.set_min(dimension() - 1, -0.04);
    clamp.set_max(dimension() - 1, 0);
    made.the_case.mutable_solid()->mutable_fem()->set_element(0.03);
    made.the_case.mutable_solid()->mutable_modal()->set_modes(6);
    made.probe("tip", 0.13, 0.12);
    return made;
  }
};

TEST_P(Slap, APlateThatIsPushedAgainstAWallStopsThere) {
  ContactScene made = scene();
  made.the_case.mutable_fluid()->mutable_tank()->set_max(0, 0.15);
  ContactRun run(made.the_case, made.points());
  const double push = 156 * made.depth();  // bends it by 40 mm, and swings to 80
  double taken = 0;
  while (run.windows < 100) {
    run.load.force.row(0).setConstant(push / static_cast<double>(run.interface.points()));
    run.advance();
    taken = std::max(taken, std::abs(run.value("interface_work")));
    expect_accounts(run, taken);
    EXPECT_LT(run.value("tip_x"), 0.02 + 0.3 * ContactScene::spacing);  // it has but an edge there
  }
  EXPECT_GT(taken, 0);
  ASSERT_EQ(run.notes.size(), 1u);
  EXPECT_NE(run.notes[0].find("solid.body.0 touches the wall of the tank at x = 0.15 m"), std::string::npos)
      << run.notes[0];
}

TEST_P(Slap, WhereNothingIsNearARunHasTheBitsOfOneWithoutATank) {
  ContactScene made = scene();
  v1::Case alone = made.the_case;
  alone.mutable_solid()->set_spacing(ContactScene::spacing);
  alone.clear_fluid();
  ContactRun with(made.the_case, made.points()), without(alone, made.points());
  for (int k = 0; k < 30; ++k) {
    for (ContactRun* run : {&with, &without}) {
      run->load.force.row(0).setConstant(20 * made.depth() / static_cast<double>(run->interface.points()));
      run->advance();
    }
    for (const char* name : {"tip_x", "kinetic_energy", "substeps"})
      ASSERT_EQ(with.value(name), without.value(name)) << name << k;
  }
  EXPECT_GT(with.value("tip_x"), 1e-3);
  EXPECT_EQ(with.value("contact_work"), 0);
}

INSTANTIATE_TEST_SUITE_P(DeformableModels, Slap,
                         Combine(Values(Word::mps, Word::hamiltonian, Word::fem, Word::modal), Values(2, 3)),
                         [](const auto& scene) {
                           return title(std::get<0>(scene.param), std::get<1>(scene.param));
                         });

}  // namespace
}  // namespace cosurge
