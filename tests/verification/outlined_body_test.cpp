// Water against a body that an outline draws: cases/dam_break_flap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/case/case_file.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

class OutlinedFlap : public ::testing::TestWithParam<const char*> {};

/// The flap stands in water of a third of its height; some windows after the start.
TEST_P(OutlinedFlap, CarriesTheWaterAndWorkIsTheSameOnBothSides) {
  const v1::Case c =
      load_case(COSURGE_SOURCE_DIR "/cases/dam_break_flap",
                {std::string("solid.model=") + GetParam(), "time.end=0.02", "time.window=2e-4",
                 "coupling.load=ramped", "fluid.water=[{ min = [0.0, 0.0], max = [0.24, 0.048] }]",
                 "solid.sprung.spring=[{ motion = \"x\", stiffness = 2e6 }]"});
  const Recording run(c);
  const auto& force = run.column("fluid/load_x");
  // rho g h (h - l0) / 2 = 10.36 N/m on any face that the water stands against, however it leans: the
  // surface's own layer has no pressure. The mean, as the water settles (3 % on a fixed flap) and the flap
  // swings.
  double mean = 0;
  for (std::size_t k = force.size() / 2; k < force.size(); ++k)
    mean += force[k] / static_cast<double>(force.size() - force.size() / 2);
  RecordProperty("over_hydrostatic", std::to_string(mean / 10.36));
  EXPECT_NEAR(mean / 10.36, 1, 0.08);
  const double given = run.column("coupling/work_points").back();
  if (std::string(GetParam()) == "rigid") return;
  const double taken = run.column("solid/interface_work").back();
  EXPECT_NE(taken, 0);
  EXPECT_NEAR(given, taken, 1e-9 * std::abs(taken));
}

INSTANTIATE_TEST_SUITE_P(Models, OutlinedFlap,
                         ::testing::Values("mps", "hamiltonian", "fem", "modal", "sprung", "rigid"),
                         [](const auto& model) { return std::string(model.param); });

}  // namespace
}  // namespace cosurge::testing
