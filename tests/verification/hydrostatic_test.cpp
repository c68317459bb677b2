// Water at rest: cases/hydrostatic.
#include <gtest/gtest.h>

#include <cmath>

#include "common/case/case_file.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

constexpr float wall = 1;
constexpr float fluid = 0;

/// Root mean square of the error of the wall's pressure in a frame, over rho g H. The walls are those that
/// water stands against: floor and sides up to a spacing below the surface, whose particles have no room for
/// half their neighbours.
double wall_error(const v1::Case& c, const Snapshot& frame) {
  const auto& x = array(frame, "position");
  const auto& p = array(frame, "pressure");
  const auto& kind = array(frame, "kind");
  const v1::Shape& water = c.fluid().water(0);
  const double l0 = c.fluid().spacing();
  const double depth = water.max(1);
  const double rho_g = -c.fluid().density() * c.gravity(1);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const bool beside = x[2 * i] > water.min(0) - l0 && x[2 * i] < water.max(0) + l0;
    if (kind[i] != wall || !beside || x[2 * i + 1] > depth - 2 * l0) continue;
    const double error = p[i] - rho_g * (depth - x[2 * i + 1]);
    sum += error * error;
    ++count;
  }
  EXPECT_GT(count, 150);
  return std::sqrt(sum / count) / (rho_g * depth);
}

double surface_level(const Snapshot& frame) {
  const auto& x = array(frame, "position");
  const auto& kind = array(frame, "kind");
  double top = 0;
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (kind[i] == fluid) top = std::max(top, static_cast<double>(x[2 * i + 1]));
  return top;
}

TEST(Hydrostatic, WallPressureIsThatOfTheDepthAndNothingDrifts) {
  const v1::Case c = load_case(COSURGE_SOURCE_DIR "/cases/hydrostatic");
  const Recording run(c);
  double sum = 0;
  int frames = 0;
  for (const auto& [time, snapshots] : run.frames()) {
    if (time < 1.0 - 1e-9) continue;
    const double error = wall_error(c, snapshots.front());
    RecordProperty("rms_error_" + std::to_string(frames), std::to_string(error));
    std::printf("t = %.2f s: wall pressure off by %.4f rho g H rms\n", time, error);
    sum += error * error;
    ++frames;
  }
  ASSERT_GE(frames, 10);
  EXPECT_LT(std::sqrt(sum / frames), 0.01);

  // The centres of the top particles lie half a spacing below the surface: level and volume to a spacing.
  EXPECT_NEAR(surface_level(run.frames().back().second.front()), 0.2 - 0.5 * 0.0025, 0.0025);
  for (const double lost : run.column("fluid/lost")) ASSERT_EQ(lost, 0);
  // The water keeps its density with any arrangement of the particles: the energy of its weight stays within
  // 0.1 %. With the smooth density (2b) it would sink by 0.2 %, with the number density expand by 4 %.
  const auto& energy = run.column("fluid/gravity_energy");
  EXPECT_NEAR(energy.back() / energy.front(), 1, 0.001);
  // Kinetic energy decays from the rearrangement of the lattice to noise: below 1e-3 of the potential energy.
  EXPECT_LT(run.column("fluid/kinetic_energy").back(), 1e-3 * energy.front());
}

}  // namespace
}  // namespace cosurge::testing
