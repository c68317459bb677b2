// The verification case of Amaro & Cheng compared with published results: cases/dam_break_plate.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/case/case_file.hpp"
#include "tests/support/recording.hpp"

namespace cosurge::testing {
namespace {

struct Landmarks {
  double front_arrives = NAN;  ///< front at the plate's face [s]
  double first_motion = NAN;   ///< tip 0.2 mm away from rest [s]
  double peak = 0;             ///< peak tip displacement [m]
  double peak_time = NAN;      ///< [s]
};

Landmarks landmarks(const Recording& run, double face) {
  Landmarks found;
  const auto& front = run.column("fluid/front");
  const auto& tip = run.column("solid/tip_x");
  for (std::size_t k = 0; k < tip.size(); ++k) {
    const double t = run.time()[k];
    if (std::isnan(found.front_arrives) && front[k] > face - 0.0005) found.front_arrives = t;
    if (std::isnan(found.first_motion) && std::abs(tip[k]) > 2e-4) found.first_motion = t;
    if (tip[k] > found.peak) {
      found.peak = tip[k];
      found.peak_time = t;
    }
  }
  std::printf("front arrives %.4f s, first motion %.4f s, tip peak %.4f m at %.4f s\n", found.front_arrives,
              found.first_motion, found.peak, found.peak_time);
  return found;
}

void expect_no_leak(const Recording& run) {
  for (const double lost : run.column("fluid/lost")) ASSERT_EQ(lost, 0);
  for (const double inside : run.column("fluid/inside_bodies")) ASSERT_EQ(inside, 0);
}

// Published peaks: 0.041 to 0.049 m at 0.22 to 0.26 s, first motion 0.135 to 0.15 s (docs/method.md,
// sources).
TEST(DamBreakPlate, TipFollowsThePublishedCurvesAt2mm) {
  const Recording run(load_case(COSURGE_SOURCE_DIR "/cases/dam_break_plate", {"time.end=0.5"}));
  const Landmarks found = landmarks(run, 0.292);
  EXPECT_GE(found.peak, 0.038);
  EXPECT_LE(found.peak, 0.052);
  EXPECT_GE(found.peak_time, 0.21);
  EXPECT_LE(found.peak_time, 0.27);
  EXPECT_GE(found.first_motion, 0.13);
  EXPECT_LE(found.first_motion, 0.16);
  // The inviscid front on a dry bed, released at once, is at 2 a at T = t sqrt(2 g / a) = 1.45 (Koshizuka &
  // Oka's computation: 1.44); experiments, which open a gate, are 0.2 to 0.3 later.
  EXPECT_NEAR(found.front_arrives, 0.125, 0.005);
  expect_no_leak(run);
}

// On a lattice of 4 mm (the column 2 mm narrower, so that it divides), short enough for every test run: as
// the case recommends, and as the paper has it.
class DamBreakPlateCoarse : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(DamBreakPlateCoarse, TipPeaksNearThePublishedBand) {
  std::vector<std::string> words{"time.end=0.3", "time.window=2e-4", "fluid.spacing=0.004",
                                 "fluid.water.0.max=[0.144, 0.292]"};
  words.insert(words.end(), GetParam().begin(), GetParam().end());
  const Recording run(load_case(COSURGE_SOURCE_DIR "/cases/dam_break_plate", words));
  const Landmarks found = landmarks(run, 0.292);
  // Coarse plates of three particles are soft (f1 -13 %): the band is the one of the prototype, 0.045 to
  // 0.056 m.
  EXPECT_GE(found.peak, 0.038);
  EXPECT_LE(found.peak, 0.060);
  EXPECT_GE(found.peak_time, 0.21);
  EXPECT_LE(found.peak_time, 0.27);
  EXPECT_GE(found.first_motion, 0.12);
  EXPECT_LE(found.first_motion, 0.16);
  expect_no_leak(run);
}

INSTANTIATE_TEST_SUITE_P(Settings, DamBreakPlateCoarse,
                         ::testing::Values(std::vector<std::string>{},
                                           std::vector<std::string>{"solid.model=mps",
                                                                    "fluid.source=deviation",
                                                                    "fluid.gradient=p_min"}),
                         [](const auto& words) { return words.param.empty() ? "Recommended" : "Paper"; });

/// Energy created by the scheme over the total work, for 0.1 m of water released beside the plate on a
/// lattice of 1 mm, in windows of 0.1 ms.
double created_beside_still_water(const std::vector<std::string>& structure) {
  std::vector<std::string> words = {
      "fluid.spacing=0.001",         "fluid.water.0.min=[0.242, 0.0]", "fluid.water.0.max=[0.292, 0.09]",
      "fluid.tank.min=[0.242, 0.0]", "fluid.tank.max=[0.34, 0.12]",    "time.window=1e-4",
      "time.stepping=fixed",         "coupling.scheme=weak",           "time.end=0.03"};
  words.insert(words.end(), structure.begin(), structure.end());
  const Recording run(load_case(COSURGE_SOURCE_DIR "/cases/dam_break_plate", words));
  const auto& work = run.column("coupling/work_points");
  double passed = 0;
  for (std::size_t k = 1; k < work.size(); ++k) passed += std::abs(work[k] - work[k - 1]);
  return run.column("coupling/work_created").back() / passed;
}

// Both sides of the stability limit of weak coupling (docs/stability.md, finer lattices): finer water
// responds faster, and the damping of waves through a soft plate's thickness must exceed the energy that this
// response adds.
TEST(FineLattice, WeakCouplingNeedsElementsThatDampTheirFastestMotions) {
  EXPECT_LT(std::abs(created_beside_still_water({})), 0.02);                   // 0.003 to 0.006 seen
  EXPECT_GT(created_beside_still_water({"solid.fem.rho_infinity=0.9"}), 0.1);  // 0.5 to 0.8 seen
}

TEST(FineLattice, WeakCouplingNeedsParticlesWithViscosity) {
  for (const std::string model : {"mps", "hamiltonian"}) {
    const std::string word = "solid.model=" + model, none = "solid." + model + ".viscosity=0";
    EXPECT_LT(std::abs(created_beside_still_water({word})), 0.02)
        << model;                                                       // 0.003 in docs/tables/plate_fine.csv
    EXPECT_GT(created_beside_still_water({word, none}), 0.1) << model;  // 1.3 and more there
  }
}

}  // namespace
}  // namespace cosurge::testing
