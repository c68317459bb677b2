// A wedge that is driven into water: as an obstacle, as a rigid body, and dropped with a large mass.
#include <gtest/gtest.h>

#include <cmath>

#include "common/case/case_file.hpp"
#include "tests/support/recording.hpp"

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

}  // namespace
}  // namespace cosurge::testing
