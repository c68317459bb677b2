#include "solid_solver/hyperelasticity.hpp"

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

/// Every law in every plane, Poisson's ratio 0.3.
class Laws : public testing::TestWithParam<std::tuple<bool, bool>> {
 protected:
  Elasticity material() const {
    return {.density = 1,
            .young_modulus = 2.6,
            .poisson_ratio = 0.3,
            .plane_stress = std::get<1>(GetParam()),
            .neo_hookean = std::get<0>(GetParam())};
  }
  static Mat<2> H() { return Mat<2>{{0.2, 0.15}, {-0.1, -0.12}}; }
};

/// E of H + t dH, whose derivative by t at 0 is sym(F^T dH).
TEST_P(Laws, StressIsTheDerivativeOfTheEnergy) {
  const double step = 1e-6;  // central differences: step^2, and rounding of the energy over it, 1e-10
  for (const Mat<2>& dH : {Mat<2>{{1, 0}, {0, 0}}, Mat<2>{{0, 1}, {0.5, 0}}, Mat<2>{{0, 0}, {0, 1}}}) {
    const Mat<2> F = Mat<2>::Identity() + H(), P = F * respond<2>(H(), material()).S;
    const double slope =
        (respond<2>(H() + step * dH, material()).energy - respond<2>(H() - step * dH, material()).energy) /
        (2 * step);
    EXPECT_NEAR(slope, P.cwiseProduct(dH).sum(), 1e-9);
  }
}

TEST_P(Laws, StiffnessIsTheDerivativeOfTheStress) {
  const double step = 1e-6;
  const Response<2> at = respond<2>(H(), material());
  for (const Mat<2>& dH : {Mat<2>{{1, 0}, {0, 0}}, Mat<2>{{0, 1}, {0.5, 0}}, Mat<2>{{0, 0}, {0, 1}}}) {
    const Mat<2> F = Mat<2>::Identity() + H(), FdH = F.transpose() * dH, dE = 0.5 * (FdH + FdH.transpose());
    const Mat<2> slope =
        (respond<2>(H() + step * dH, material()).S - respond<2>(H() - step * dH, material()).S) / (2 * step);
    const Mat<2> stiffness = at.a * at.B.cwiseProduct(dE).sum() * at.B + 2 * at.b * at.B * dE * at.B;
    EXPECT_LT((slope - stiffness).norm(), 1e-9);
  }
}

TEST_P(Laws, SmallStrainsFollowHooke) {
  const double strain = 1e-6, E = 2.6, nu = 0.3;
  const Mat<2> stretch{{strain, 0}, {0, 0}}, S = respond<2>(stretch, material()).S / strain;
  const double along = std::get<1>(GetParam()) ? E / (1 - nu * nu) : E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  EXPECT_NEAR(S(0, 0) / along, 1, 1e-5);  // nonlinear terms of a few strains
  EXPECT_NEAR(S(1, 1) / S(0, 0), std::get<1>(GetParam()) ? nu : nu / (1 - nu), 1e-5);
}

TEST_P(Laws, InPlaneStressAllOfSpaceAgrees) {
  if (!std::get<1>(GetParam())) return;
  // The same deformation in space, with the stretch across that the law found: no stress across, the same
  // energy.
  const Response<2> plane = respond<2>(H(), material());
  Mat<3> in_space = Mat<3>::Zero();
  in_space.topLeftCorner<2, 2>() = H();
  in_space(2, 2) = std::sqrt(plane.across2) - 1;
  Elasticity whole = material();
  whole.plane_stress = false;
  const Response<3> space = respond<3>(in_space, whole);
  EXPECT_NEAR(space.S(2, 2), 0, 1e-13);
  EXPECT_NEAR(space.energy / plane.energy, 1, 1e-13);
  EXPECT_LT((space.S.topLeftCorner<2, 2>() - plane.S).norm(), 1e-13);
  EXPECT_NEAR(von_mises_stress<3>(Mat<3>::Identity() + in_space, whole),
              von_mises_stress<2>(Mat<2>::Identity() + H(), material()), 1e-12);
}

TEST_P(Laws, RotationCausesNoStress) {
  Mat<2> R;
  R << 0.6, -0.8, 0.8, 0.6;
  EXPECT_LT(respond<2>(R - Mat<2>::Identity(), material()).S.norm(), 1e-14);
  EXPECT_NEAR(respond<2>(R - Mat<2>::Identity(), material()).energy, 0, 1e-14);
}

TEST_P(Laws, VonMisesStressInPlaneStrainIsThatOfSpace) {
  if (std::get<1>(GetParam())) return;
  Mat<3> F = Mat<3>::Identity();
  F.topLeftCorner<2, 2>() += H();
  EXPECT_NEAR(von_mises_stress<2>(F.topLeftCorner<2, 2>(), material()), von_mises_stress<3>(F, material()),
              1e-13);
}

INSTANTIATE_TEST_SUITE_P(All, Laws, testing::Combine(testing::Bool(), testing::Bool()),
                         [](const auto& choice) {
                           return std::string(std::get<0>(choice.param) ? "neo_hookean"
                                                                        : "st_venant_kirchhoff") +
                                  (std::get<1>(choice.param) ? "_plane_stress" : "_plane_strain");
                         });

}  // namespace
}  // namespace cosurge
