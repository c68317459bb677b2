// A column of water on a soft floor: cases/soft_floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

v1::Case soft_floor(const std::vector<std::string>& words) {
  return load_case(COSURGE_SOURCE_DIR "/cases/soft_floor", words);
}

double largest(const std::vector<double>& values, double from, double to) {
  const auto at = [&](double share) {
    return values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  };
  return *std::max_element(at(from), at(to));
}

class SoftFloor : public ::testing::TestWithParam<const char*> {};

// A pressure in response to the compression of the structure itself drives its waves: with it the kinetic
// energy grew a thousandfold here. Now the water has numerical damping only.
TEST_P(SoftFloor, UnderWaterComesToRest) {
  const Recording run(soft_floor({std::string("solid.model=") + GetParam()}));
  const auto& energy = run.column("solid/kinetic_energy");
  EXPECT_GT(largest(energy, 0, 0.2), 1e-4);  // it swings: half the mass times (40 um * 2 pi * 80 Hz)^2
  EXPECT_LT(largest(energy, 0.8, 1), 0.2 * largest(energy, 0, 0.2));
  // It spans the tank from wall to wall and slides along the walls without contact, which would need
  // sub-steps.
  EXPECT_EQ(largest(run.column("solid/contact_points"), 0, 1), 0);
}

INSTANTIATE_TEST_SUITE_P(Models, SoftFloor, ::testing::Values("mps", "hamiltonian", "fem"),
                         [](const auto& model) { return std::string(model.param); });

TEST(SoftFloor, SwingsAtTheFrequencyOfABarWithTheWaterOnTop) {
  const Recording run(soft_floor({"time.window=2e-4", "time.end=0.12", "output.frame_interval=0.06"}));
  const auto& y = run.column("solid/floor_y");
  const auto half = static_cast<std::ptrdiff_t>(y.size() / 2);  // five periods
  const double rest = std::accumulate(y.begin() + half, y.end(), 0.0) / static_cast<double>(half);
  // rho g H b / E + rho_s g e^2 / 2 E; the surface's truncated Laplacian is worth a spacing of 40, and
  // elements of 6.7 mm under points every 5 mm are loaded unevenly: by 1.5 % at the probe (elements of 10 mm:
  // 0.2 %).
  EXPECT_NEAR(rest, -39.2e-6, 0.05 * 39.2e-6);
  std::vector<double> passages;
  for (std::size_t k = 1; k < y.size(); ++k)
    if (y[k - 1] < rest && y[k] >= rest)
      passages.push_back(run.time()[k - 1] + 2e-4 * (rest - y[k - 1]) / (y[k] - y[k - 1]));
  ASSERT_GE(passages.size(), 3U);
  const double frequency = static_cast<double>(passages.size() - 1) / (passages.back() - passages.front());
  RecordProperty("frequency", std::to_string(frequency));
  EXPECT_NEAR(frequency / 80.9, 1, 0.03);  // measured 1.017: the same spacing, and the walls' columns
}

TEST(SoftFloor, LighterThanItsWaterIsBeyondWeakCoupling) {
  // mu = rho H / (rho_s e) = 4; the limit of weak coupling is 2. The only energy available is the work of the
  // water's weight on the way down, rho g H x 39 um x 0.1 m = 8 mJ.
  constexpr double all_there_is = 8e-3;
  const auto weak_energy = [](double rho_infinity) {
    const std::string damping = "solid.fem.rho_infinity=" + std::to_string(rho_infinity);
    try {
      const Recording run(soft_floor({"coupling.scheme=weak", damping}));
      return largest(run.column("solid/kinetic_energy"), 0, 1);
    } catch (const NumericalError&) {
      return static_cast<double>(INFINITY);
    }
  };
  EXPECT_GT(weak_energy(0.8), 0.1);
  EXPECT_GT(weak_energy(0.3), 5 * all_there_is);  // the default's elements damp more: 8 times seen
  EXPECT_LT(largest(Recording(soft_floor({})).column("solid/kinetic_energy"), 0, 1), all_there_is);
}

TEST(SoftFloor, IsTheSameInFewerIterationsWithTheModesAddedMass) {
  const auto run = [](const std::string& scheme) {
    return Recording(soft_floor(
        {"coupling.scheme=" + scheme, "coupling.velocity=end", "coupling.modes=8", "fluid.source=mixed"}));
  };
  const Recording without = run("strong"), with = run("strong_inertial");
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  // 3.3 and 2.2 measured; eight modes of the elements are known.
  EXPECT_LT(mean(with.column("coupling/iterations")), 0.8 * mean(without.column("coupling/iterations")));
  const auto &a = with.column("solid/floor_y"), &b = without.column("solid/floor_y");
  const double deepest = -*std::min_element(b.begin(), b.end());
  for (std::size_t k = 0; k < b.size(); ++k)
    ASSERT_NEAR(a[k], b[k], 0.01 * deepest) << k;  // ten tolerances of a window: errors of later ones add up
}

}  // namespace
}  // namespace cosurge::testing
