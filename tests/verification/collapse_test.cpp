// A collapsing column of water: cases/dam_break_rigid on a lattice of 4 mm, until its front is at the plate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "common/case/case_file.hpp"
#include "common/vec.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

constexpr double width = 0.148;  // width of the column [m], a multiple of 4 mm
constexpr double g = 9.81;

struct Curve {
  std::vector<double> t, z;
};

/// Front of a published column: T = t sqrt(2 g / a), Z = x / a.
Curve published(const std::string& name) {
  std::ifstream file(COSURGE_SOURCE_DIR "/cases/dam_break_rigid/reference/" + name);
  std::string line;
  std::getline(file, line);
  Curve curve;
  double t = 0;
  double z = 0;
  for (char comma = 0; file >> t >> comma >> z;) {
    curve.t.push_back(t);
    curve.z.push_back(z);
  }
  return curve;
}

double at(const Curve& curve, double t) {
  std::size_t k = 1;
  while (k + 1 < curve.t.size() && curve.t[k] < t) ++k;
  const double share = (t - curve.t[k - 1]) / (curve.t[k] - curve.t[k - 1]);
  return curve.z[k - 1] + share * (curve.z[k] - curve.z[k - 1]);
}

/// Area of the cells l0 x l0 around the water's particles inside a box, over the box's: 1 where the water has
/// its density.
double filled(const Snapshot& frame, double l0, const Vec<2>& low, const Vec<2>& high) {
  const auto& x = array(frame, "position");
  const auto& kind = array(frame, "kind");
  double area = 0;
  for (std::size_t i = 0; i < kind.size(); ++i) {
    if (kind[i] != 0) continue;
    double part = 1;
    for (int k = 0; k < 2; ++k)
      part *=
          std::max(0.0, std::min(x[2 * i + k] + l0 / 2, high[k]) - std::max(x[2 * i + k] - l0 / 2, low[k]));
    area += part;
  }
  return area / (high - low).prod();
}

class CollapsingColumn : public ::testing::TestWithParam<const char*> {};

TEST_P(CollapsingColumn, KeepsVolumeAndEnergyAndRunsAsPublished) {
  const Recording run(load_case(
      COSURGE_SOURCE_DIR "/cases/dam_break_rigid",
      {"fluid.spacing=0.004", "fluid.water.0.max=[0.148, 0.292]", "time.end=0.12", "time.window=1e-4",
       "fluid.gradient=corrected", "fluid.propagation_speed=1", std::string("fluid.source=") + GetParam()}));

  // A box deep in the water. Kept to the number density of the small radius it swells by 4 to 6 %. Measured
  // here: up to 1 %, and as much again in single frames, since the box is 22 x 12 spacings and its rim counts
  // by halves.
  for (const auto& [time, frame] : run.frames()) {
    if (time > 0.1) break;
    EXPECT_NEAR(filled(frame.front(), 0.004, {0.012, 0.012}, {0.1, 0.06}), 1, 0.02) << time;
  }

  // Nothing but gravity drives it: the energy may not grow by more than 1 % of what moves (with the small
  // radius, 6 %), nor may much be lost before the water meets anything.
  const auto& kinetic = run.column("fluid/kinetic_energy");
  const auto& weight = run.column("fluid/gravity_energy");
  for (std::size_t k = 0; k < run.time().size(); ++k) {
    if (run.time()[k] < 0.05 || run.time()[k] > 0.1) continue;
    const double gain = kinetic[k] + weight[k] - (kinetic[0] + weight[0]);
    EXPECT_LT(gain, 0.015 * kinetic[k]) << run.time()[k];
    EXPECT_GT(gain, -0.03 * kinetic[k]) << run.time()[k];
  }

  // The result equals Koshizuka & Oka's computation, which also releases the water at once, to the accuracy
  // of the read curves and a spacing. Martin & Moyce's water, behind a gate, is never ahead.
  const Curve computed = published("koshizuka_oka_1996.csv");
  const Curve measured = published("martin_moyce_1952_225.csv");
  for (double T = 0.5; T < 1.35; T += 0.1) {
    const double time = T / std::sqrt(2 * g / width);
    const auto k = static_cast<std::size_t>(std::lower_bound(run.time().begin(), run.time().end(), time) -
                                            run.time().begin());
    const double z = run.column("fluid/front")[k] / width;
    EXPECT_NEAR(z, at(computed, T), 0.06) << T;
    EXPECT_GT(z, at(measured, T)) << T;
  }
}

INSTANTIATE_TEST_SUITE_P(Sources, CollapsingColumn, ::testing::Values("mixed", "time_scale"),
                         [](const auto& word) { return std::string(word.param); });

}  // namespace
}  // namespace cosurge::testing
