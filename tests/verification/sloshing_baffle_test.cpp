// A baffle that is clamped to the floor of a rolling tank: cases/sloshing_baffle.
#include <gtest/gtest.h>

#include <cmath>

#include "common/case/case_file.hpp"
#include "common/case/from_case.hpp"
#include "common/geometry/motion.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

/// Farthest that the tip is from where the tank carries it [m].
double strayed(const std::vector<std::string>& settings) {
  std::vector<std::string> all = {
      "time.end=0.6", "fluid.spacing=0.01", "solid.body.0.box={ min = [0.28, 0.0], max = [0.32, 0.09] }",
      "solid.body.0.clamp=[{ min = [0.28, -0.04], max = [0.32, 0.0] }]",
      "fluid.water=[{ min = [0.0, 0.0], max = [0.28, 0.12] }, { min = [0.32, 0.0], max = [0.6, 0.12] }]"};
  all.insert(all.end(), settings.begin(), settings.end());
  const v1::Case c = load_case(COSURGE_SOURCE_DIR "/cases/sloshing_baffle", all);
  const Recording run(c);
  const auto tank = from_case<2>(c.fluid().tank_motion());
  const Vec<2> X(0.3, 0.09);
  double farthest = 0;
  for (std::size_t k = 0; k < run.time().size(); ++k) {
    const Vec<2> x = X + Vec<2>(run.column("solid/tip_x")[k], run.column("solid/tip_y")[k]);
    farthest = std::max(farthest, (x - tank.place(X, run.time()[k])).norm());
  }
  const double given = run.column("coupling/work_points").back(),
               taken = run.column("solid/interface_work").back();
  EXPECT_NEAR(given, taken, 1e-9 * std::abs(taken));
  EXPECT_GT(std::abs(tank.place(X, 0.4)[0] - X[0]), 5e-3);  // the tank does move
  return farthest;
}

TEST(SloshingBaffle, MovesWithTheTank) {
  EXPECT_LT(strayed({"solid.model=rigid"}), 1e-15);
  EXPECT_LT(strayed({"solid.young_modulus=1e10", "coupling.scheme=weak"}), 1e-6);
}

TEST(SloshingBaffle, BendsAlikeWithEveryModel) {
  const double elements = strayed({}), modes = strayed({"solid.model=modal"}),
               particles = strayed({"solid.model=hamiltonian"});
  RecordProperty("bent", fmt::format("{:.3g} {:.3g} {:.3g}", elements, modes, particles));
  EXPECT_GT(elements, 1e-4);
  EXPECT_NEAR(modes, elements, 0.15 * elements);
  EXPECT_NEAR(particles, elements, 0.15 * elements);
}

TEST(SloshingBaffle, StandsStillWhereItSaysSo) {
  const v1::Case c =
      load_case(COSURGE_SOURCE_DIR "/cases/sloshing_baffle", {"solid.body.0.motion={}", "solid.model=rigid"});
  EXPECT_TRUE(c.solid().body(0).has_motion());
  EXPECT_FALSE(from_case<2>(c.solid().body(0).motion()).moves());
  EXPECT_FALSE(load_case(COSURGE_SOURCE_DIR "/cases/sloshing_baffle").solid().body(0).has_motion());
}

}  // namespace
}  // namespace cosurge::testing
