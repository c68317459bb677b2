#include "solid_solver/elasticity.hpp"

#include <gtest/gtest.h>

namespace cosurge {
namespace {

const Elasticity steel{.density = 7800, .young_modulus = 2e11, .poisson_ratio = 0.3};

TEST(Elasticity, WaveSpeedsAreThoseOfSteel) {
  EXPECT_NEAR(steel.pressure_speed(), 5875, 0.5);  // rounded to the metre per second in tables
  EXPECT_NEAR(steel.shear_speed(), 3140, 0.5);
}

TEST(VonMises, RotationCausesNoStress) {
  Mat<2> R;
  R << 0.6, -0.8, 0.8, 0.6;
  EXPECT_NEAR(von_mises_stress<2>(R, steel), 0, 1e-4);  // rounding of the strain, 1e-16, times E
}

TEST(VonMises, SmallStretchInPlaneStrainIsTheHandValue) {
  const double strain = 1e-7;
  Mat<2> F = Mat<2>::Identity();
  F(0, 0) += strain;
  // sigma = (lambda + 2 mu, lambda, lambda) strain: the deviator's von Mises measure is 2 mu strain.
  EXPECT_NEAR(von_mises_stress<2>(F, steel) / (2 * steel.mu() * strain), 1,
              1e-6);  // nonlinear terms of order strain
}

TEST(VonMises, SmallShearIsRootThreeTimesTheShearStress) {
  const double strain = 1e-7;
  Mat<2> F = Mat<2>::Identity();
  F(0, 1) = strain;
  EXPECT_NEAR(von_mises_stress<2>(F, steel) / (std::sqrt(3.0) * steel.mu() * strain), 1, 1e-6);  // as above
}

}  // namespace
}  // namespace cosurge
