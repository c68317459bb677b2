// Accounts of momentum and energy where bodies touch, scene by scene.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

#include "tests/support/contact_scene.hpp"

namespace cosurge {
namespace {

using test::ContactRun;
using test::ContactScene;
using Word = v1::SolidModel;

constexpr double g = 9.81;
constexpr double rho = ContactScene::density;

/// Allowed error of the energy by the contact springs, and of the model's own energy, relative to the energy
/// of the blows. Largest values in the plane: 2.4 % (`mps`), 0.7 % (`hamiltonian`, and `sprung` between two
/// slopes).
/// slopes).
double allowed(Word::Word model) { return model == Word::mps ? 0.04 : 0.02; }

struct Scene {
  std::string name;
  double windows;
  std::function<double(ContactScene&)> build;  // returns the energy of the blows [J]
  bool outside = false;                        // whether anything but bodies is touched
  bool of_large_motion = false;                // bodies turn: not for linear models
};

v1::Shape tilted(const ContactScene& scene, Vec<2> centre, double width, double height, double angle) {
  std::vector<Vec<2>> corners;
  for (const auto& [x, y] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const Vec<2> arm(x * width, y * height);
    corners.emplace_back(centre + Vec<2>(std::cos(angle) * arm[0] - std::sin(angle) * arm[1],
                                         std::sin(angle) * arm[0] + std::cos(angle) * arm[1]));
  }
  return scene.outline(corners);
}

/// Gravity along x drives the bodies against a wall or each other; energies are rho a way.
const Scene scenes[] = {
    {"ABlockLandsOnItsEdge", 110,
     [](ContactScene& s) {
       s.gravity(0, -g);
       *s.the_case.mutable_solid()->add_body()->mutable_shape() = tilted(s, {0.2, 0.06}, 0.06, 0.04, 0.5);
       return rho * 0.06 * 0.04 * s.depth() * g * 0.03;
     },
     true, true},
    {"ABlockFallsOnAnother", 110,
     [](ContactScene& s) {
       s.gravity(0, -g);
       s.add_block(0.1, 0, 0.1, 0.04);
       s.add_block(0.12, 0.06, 0.05, 0.04);
       return rho * 0.05 * 0.04 * s.depth() * g * 0.02;
     },
     true},
    {"ASmallOneFallsOnTheEdgeOfALargeOne", 90,
     [](ContactScene& s) {
       s.gravity(0, -g);
       s.add_block(0.1, 0, 0.16, 0.06);
       s.add_block(0.24, 0.08, 0.04, 0.04);
       return rho * 0.04 * 0.04 * s.depth() * g * 0.02;
     },
     true, true},
    {"ABlockRunsIntoTheCornerOfFloorAndWall", 130,
     [](ContactScene& s) {
       s.gravity(-g, -g);
       s.add_block(0.02, 0.02, 0.05, 0.05);
       return rho * 0.05 * 0.05 * s.depth() * g * 0.04;
     },
     true},
    {"TwoBlocksRunIntoAWallOneBehindTheOther", 130,
     [](ContactScene& s) {
       s.gravity(-g, 0);
       s.add_block(0.02, 0.1, 0.05, 0.04);
       s.add_block(0.08, 0.1, 0.05, 0.04);
       return 2 * rho * 0.05 * 0.04 * s.depth() * g * 0.025;
     },
     true},
    {"ABlockBouncesAgainAndAgain", 500,
     [](ContactScene& s) {
       s.gravity(0, -g);
       s.add_block(0.1, 0.01, 0.06, 0.04);
       return 5 * rho * 0.06 * 0.04 * s.depth() * g * 0.01;  // some five blows
     },
     true},
    {"ABlockFallsBetweenTwoSlopes", 120,
     [](ContactScene& s) {
       s.gravity(0, -g);
       *s.the_case.mutable_fluid()->add_obstacle()->mutable_shape() =
           s.outline({{0, 0}, {0.2, 0}, {0, 0.2}}, 0, 0.4);
       *s.the_case.mutable_fluid()->add_obstacle()->mutable_shape() =
           s.outline({{0.2, 0}, {0.4, 0}, {0.4, 0.2}}, 0, 0.4);
       *s.the_case.mutable_solid()->add_body()->mutable_shape() =
           s.outline({{0.2, 0.02}, {0.25, 0.07}, {0.2, 0.12}, {0.15, 0.07}});
       return rho * 0.005 * s.depth() * g * 0.02;
     },
     true},
};

class ContactAccounts : public testing::TestWithParam<std::tuple<Scene, Word::Word, int>> {};

TEST_P(ContactAccounts, Balance) {
  const auto& [scene, model, dimension] = GetParam();
  if (scene.of_large_motion && model == Word::modal) return;  // a linear model does not turn
  ContactScene made(model, dimension);
  v1::SolidSprung& sprung = *made.the_case.mutable_solid()->mutable_sprung();
  for (const auto turn : dimension == 2
                             ? std::vector{v1::Spring::turn}
                             : std::vector{v1::Spring::turn_x, v1::Spring::turn_y, v1::Spring::turn_z})
    sprung.add_spring()->set_motion(turn);
  const double energy = scene.build(made);
  ContactRun run(made.the_case);
  double touched = 0, made_most = 0, made_least = 0, missed = 0;
  while (run.windows < scene.windows) {
    run.advance();
    touched = std::max(touched, run.value("contact_points"));
    made_most = std::max(made_most, run.made_by_contact());
    made_least = std::min(made_least, run.made_by_contact());
    missed = std::max(missed, std::abs(run.unaccounted()));
  }
  EXPECT_GT(touched, 0);
  RecordProperty("made", fmt::format("{:.3g}", made_most / energy));
  RecordProperty("lost", fmt::format("{:.3g}", -made_least / energy));
  RecordProperty("missed", fmt::format("{:.3g}", missed / energy));
  EXPECT_LT(made_most, allowed(model) * energy);
  EXPECT_GT(made_least, -allowed(model) * energy);
  EXPECT_LT(missed, allowed(model) * energy);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ContactAccounts,
                         testing::Combine(testing::ValuesIn(scenes),
                                          testing::Values(Word::sprung, Word::fem, Word::modal,
                                                          Word::hamiltonian, Word::mps),
                                          testing::Values(2)),
                         [](const auto& p) {
                           return std::get<0>(p.param).name + "_" + Word::Word_Name(std::get<1>(p.param)) +
                                  "_2d";
                         });
INSTANTIATE_TEST_SUITE_P(ScenesInSpace, ContactAccounts,
                         testing::Combine(testing::ValuesIn(scenes), testing::Values(Word::sprung, Word::fem),
                                          testing::Values(3)),
                         [](const auto& p) {
                           return std::get<0>(p.param).name + "_" + Word::Word_Name(std::get<1>(p.param)) +
                                  "_3d";
                         });

/// A block that runs against the half of another: both momenta, that about the origin of space, too.
TEST(ContactMomentum, OfBlocksThatMeetHalfwayIsKeptAroundEveryAxis) {
  for (const int dimension : {2, 3}) {
    ContactScene made(Word::sprung, dimension);
    for (const auto turn : dimension == 2
                               ? std::vector{v1::Spring::turn}
                               : std::vector{v1::Spring::turn_x, v1::Spring::turn_y, v1::Spring::turn_z})
      made.the_case.mutable_solid()->mutable_sprung()->add_spring()->set_motion(turn);
    made.gravity(0, 0);
    made.add_block(0.10, 0.10, 0.05, 0.04);
    made.add_block(0.16, 0.12, 0.05, 0.04);
    ContactRun run(made.the_case, made.points());
    const double mass = rho * 0.05 * 0.04 * made.depth();
    const auto points = static_cast<double>(run.interface.points());
    // Velocities of the sites from the frames, in single precision.
    const auto momenta = [&] {
      const Snapshot frame = run.solid.frame();
      const std::size_t d = static_cast<std::size_t>(dimension), count = frame[0].values.size() / d;
      Vec<3> sum = Vec<3>::Zero();  // along x and up, and around the axis between them
      for (std::size_t k = 0; k < count; ++k) {
        const double x = frame[0].values[d * k], y = frame[0].values[d * k + d - 1];
        const double u = frame[1].values[d * k], v = frame[1].values[d * k + d - 1];
        sum += Vec<3>(u, v, x * v - y * u) * 2 * mass / static_cast<double>(count);
      }
      return sum;
    };
    Vec<3> before = Vec<3>::Zero();
    double spun = 0;
    while (run.windows < 80) {
      run.load.force.row(0).setConstant(run.windows < 20 ? 20 * mass / points : 0);
      run.advance();
      if (run.windows == 20) before = momenta();
      if (run.windows > 20) spun = std::max(spun, std::abs(momenta()[2] - before[2]));
    }
    EXPECT_GT(run.value("contact_work"), -0.05 * 0.25 * mass * 0.4 * 0.4);
    EXPECT_EQ(run.notes.size(), 1u);
    const double scale = mass * 0.4;
    EXPECT_NEAR(momenta()[0], before[0], 1e-5 * scale);
    EXPECT_NEAR(momenta()[1], before[1], 1e-5 * scale);
    // Sites of the lattice have less inertia about the centre than the block: l0^2 / 6 over (a^2 + b^2) / 12.
    EXPECT_LT(spun, 0.06 * scale * 0.05);
  }
}

}  // namespace
}  // namespace cosurge
