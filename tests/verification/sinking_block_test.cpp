// Blocks that sink to the floor lie there, in water that still carries their buoyancy.
#include <gtest/gtest.h>

#include "common/case/case_file.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

class SinkingBlock : public ::testing::TestWithParam<const char*> {};

// Before, blocks were thrown up again, or ended the run, by the particles under them.
TEST_P(SinkingBlock, LiesOnTheFloorWithItsBuoyancy) {
  const Recording run(load_case(COSURGE_SOURCE_DIR "/tests/cases/sinking_block",
                                {std::string("solid.density=") + GetParam()}));
  const auto& height = run.column("solid/base_y");
  const auto& load = run.column("coupling/force_y");
  double lift = 0, time = 0;
  for (std::size_t k = 1; k < run.time().size(); ++k) {
    EXPECT_GT(height[k], -0.1 - 0.001) << run.time()[k];  // a tenth of a spacing into the floor
    if (run.time()[k] < 0.7) continue;
    EXPECT_LT(height[k], -0.1 + 0.002) << run.time()[k];
    lift += load[k] * (run.time()[k] - run.time()[k - 1]);
    time += run.time()[k] - run.time()[k - 1];
  }
  constexpr double buoyancy = 1000 * 9.81 * 0.1 * 0.05;
  EXPECT_NEAR(lift / time, buoyancy, 0.1 * buoyancy);  // seen: 47 to 49 N; the water still moves
}

INSTANTIATE_TEST_SUITE_P(Densities, SinkingBlock, ::testing::Values("2500", "5000", "11000"),
                         [](const auto& density) { return std::string(density.param); });

}  // namespace
}  // namespace cosurge::testing
