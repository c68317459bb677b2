// A column of water on a sprung piston: cases/sprung_piston.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/case/case_file.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

/// Time of the lowest (sign -1) or highest (+1) value between two times.
double extreme(const Recording& run, const std::vector<double>& values, double sign, double from, double to) {
  double best = -INFINITY, at = NAN;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double t = run.time()[k];
    if (t < from || t > to || sign * values[k] <= best) continue;
    best = sign * values[k];
    at = t;
  }
  return at;
}

TEST(SprungPiston, AllTheWaterAboveMovesWithThePiston) {
  const Recording run(load_case(COSURGE_SOURCE_DIR "/cases/sprung_piston", {"time.end=0.9"}));
  const auto& piston = run.column("solid/piston_y");
  const double first = extreme(run, piston, 1, 0.1, 0.4), second = extreme(run, piston, 1, 0.6, 0.9);
  const double frequency = 1 / (second - first);
  std::printf("frequency %.4f Hz, first top at %.4f s\n", frequency, first);
  RecordProperty("frequency", std::to_string(frequency));
  const double stiffness = 9474.8, mass = 40, water = 1000 * 0.1 * 0.2;
  const double exact = std::sqrt(stiffness / (mass + water)) / (2 * std::numbers::pi);
  // The piston alone would make 2.45 Hz; a tenth of the added mass is 1.7 %.
  EXPECT_NEAR(frequency / exact, 1, 0.02);
  EXPECT_NEAR(first * exact, 0.5, 0.02);  // half a period
  // From rest to twice the mean, 2 mm; the water settles by a few hundredths of a spacing of 5 mm.
  EXPECT_NEAR(*std::max_element(piston.begin(), piston.end()), 0.004, 0.0002);
  // The first pressure knows the acceleration: rho H (g + k x / (m + rho H)), x = 2 mm.
  const double pressure = 1000 * 0.2 * (9.81 + stiffness * 0.002 / (mass + water));
  EXPECT_NEAR(run.column("fluid/floor")[10] / pressure, 1, 0.01);
}

}  // namespace
}  // namespace cosurge::testing
