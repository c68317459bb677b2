// A wedge that is driven into water: as an obstacle, as a rigid body, and dropped with a large mass; and one
// that turns a slab of water.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "common/case/case_file.hpp"
#include "tests/support/recording.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

constexpr double speed = 5, end = 0.0147;

/// Mean of F / (rho V^3 t) over the second half of cases/validation/wedge_30, on 10 mm.
double force(const std::vector<std::string>& settings) {
  std::vector<std::string> all = {"fluid.spacing=0.01"};
  all.insert(all.end(), settings.begin(), settings.end());
  const Recording run(load_case(COSURGE_SOURCE_DIR "/cases/validation/wedge_30", all));
  double sum = 0, over = 0, last = 0;
  for (std::size_t k = 0; k < run.time().size(); ++k) {
    const double t = run.time()[k], dt = t - last;
    last = t;
    if (t < 0.5 * end) continue;
    sum += dt * run.column("fluid/F_y")[k] / (1000 * std::pow(speed, 3) * t);
    over += dt;
  }
  return sum / over;
}

TEST(WedgeEntry, AWedgeHasTheForceOfASimilarObstacle) {
  const double obstacle = force({});
  const std::string shape = "shape = { outline = \"wedge.csv\" }";
  const double body =
      force({"fluid.obstacle=[]", "solid.model=rigid", "solid.density=500",
             "solid.body=[{ " + shape + ", motion = { table = \"entry.csv\", along = \"y\" } }]"});
  const double dropped =
      force({"fluid.obstacle=[]", "solid.model=sprung", "solid.density=500", "solid.sprung.mass=1e5",
             "solid.sprung.spring=[{ motion = \"y\", preload = 981000 }]",
             "solid.body=[{ " + shape + ", velocity = [0.0, -5.0] }]"});
  RecordProperty("force", fmt::format("{:.4g} {:.4g} {:.4g}", obstacle, body, dropped));
  // The faces of a body are stepped on the lattice. Where the steps had normals of their own, the body
  // had 1.6 times the force on 5 mm.
  EXPECT_NEAR(body, obstacle, 0.1 * obstacle);
  EXPECT_NEAR(dropped, body, 0.02 * body);  // its weight is balanced
}

/// Mean force between 0.03 and 0.085 s on a wedge of 90 degrees that rises at 5 m/s into a slab of water 16
/// spacings thick, over the momentum that the slab loses when it is turned by 45 degrees.
double force_of_slab(const std::string& wedge) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "wedge.csv") << "0, 0\n-0.2, -0.2\n0.2, -0.2\n";
  std::ofstream(folder.path() / "rise.csv") << "0, 0\n0.1, 0.5\n";
  std::ofstream(folder.path() / "case.toml") << R"(title = "A wedge rises into a slab of water"
gravity = [0.0, -9.81]
time = { end = 0.085 }
[fluid]
spacing = 0.005
tank = { min = [0, 0], max = [1.2, 1.6] }
water = [{ min = [0.56, 0.61], max = [0.64, 1.4] }]
[output]
probe = [{ name = "F", quantity = "force", position = [0.6, 0.55] }]
)" << wedge;
  const Recording run(load_case(folder.path().string()));
  double impulse = 0, momentum = 0, last = 0;
  for (std::size_t k = 0; k < run.time().size(); ++k) {
    const double t = run.time()[k], dt = t - last, approach = speed + 9.81 * t;
    last = t;
    if (t < 0.03) continue;
    impulse -= dt * run.column("fluid/F_y")[k];
    momentum += dt * 1000 * 0.08 * std::pow(approach, 2) * (1 - std::cos(std::numbers::pi / 4));
  }
  return impulse / momentum;
}

// The water on the faces weighs a tenth of the force. With faces that stop or draw the water behind them the
// obstacle had a quarter of it.
TEST(WedgeEntry, AWedgeThatRisesIntoASlabTurnsIt) {
  const std::string wedge = R"(shape = { outline = "wedge.csv", shift = [0.6, 0.6] }
motion = { table = "rise.csv", along = "y" }
)";
  const double obstacle = force_of_slab("[[fluid.obstacle]]\n" + wedge);
  const double body = force_of_slab("[solid]\nmodel = \"rigid\"\ndensity = 500\n[[solid.body]]\n" + wedge);
  RecordProperty("force", fmt::format("{:.4g} {:.4g}", obstacle, body));
  EXPECT_NEAR(obstacle, 1.1, 0.15);
  EXPECT_NEAR(body, 1.1, 0.15);
}

}  // namespace
}  // namespace cosurge::testing
