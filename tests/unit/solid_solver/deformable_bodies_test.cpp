// What every deformable body must do. `modal` is the linear part of `fem`: its tests are those of its
// stiffness (FemBody), its modes (Modes) and its motion (Models); it does not know large rotations.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numbers>
#include <random>

#include "solid_solver/models/modal/modes.hpp"
#include "tests/support/sample_bodies.hpp"

namespace cosurge::test {
namespace {

template <typename Sample>
class DeformableBody : public testing::Test {};

using Samples = testing::Types<CorrectedSample, PaperSample, FemSample, HamiltonianSample,
                               Rubber<CorrectedSample>, Rubber<FemSample>, Rubber<HamiltonianSample>>;

class SampleNames {
 public:
  template <typename Sample>
  static std::string GetName(int) {  // NOLINT(readability-identifier-naming): GoogleTest's name
    if constexpr (std::is_same_v<Sample, CorrectedSample>) return "mps";
    if constexpr (std::is_same_v<Sample, PaperSample>) return "mps_paper";
    if constexpr (std::is_same_v<Sample, FemSample>) return "fem";
    if constexpr (std::is_same_v<Sample, Rubber<CorrectedSample>>) return "mps_rubber";
    if constexpr (std::is_same_v<Sample, Rubber<FemSample>>) return "fem_rubber";
    if constexpr (std::is_same_v<Sample, Rubber<HamiltonianSample>>) return "hamiltonian_rubber";
    return "hamiltonian";
  }
};

TYPED_TEST_SUITE(DeformableBody, Samples, SampleNames);

Mat<2> turn(double angle) {
  Mat<2> R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

Mat<2> stretch() {
  Mat<2> U;
  U << 1.08, 0.05, 0.05, 0.94;
  return U;
}

/// A motion without symmetry: strains of about 10 %.
Field bent(const Field& X) {
  Field u(2, X.cols());
  for (Eigen::Index n = 0; n < u.cols(); ++n) {
    const double x = X(0, n), y = X(1, n);
    u.col(n) << 8 * y * y + 3 * x * y + 0.05 * x, 0.02 * y - 5 * x * y + 4 * x * x;
  }
  return u;
}

TYPED_TEST(DeformableBody, AffineMotionIsInBalanceInside) {
  const Block block{.poisson_ratio = TypeParam::poisson_ratio};
  TypeParam sample(block);
  const Field X = sample.sites();
  const double angle = 0.5, width = block.columns * l0, height = block.rows * l0;
  sample.deform((turn(angle) * stretch() - Mat<2>::Identity()) * X, angle);
  const Field force = sample.force();
  const double at_faces = force.cwiseAbs().maxCoeff(), clear = TypeParam::clear_of_faces;
  int inside = 0;
  for (Eigen::Index n = 0; TypeParam::local && n < X.cols(); ++n) {
    const double x = X(0, n), y = X(1, n);
    if (std::min({x, width - x, y, height - y}) < clear) continue;
    ++inside;
    EXPECT_LT(force.col(n).norm(),
              1e-11 * at_faces);  // rounding of positions, 1e-16 of 24 l0, over strains of 0.1
  }
  EXPECT_GT(inside, TypeParam::local ? 10 : -1);
  // The forces of the faces sum to zero.
  EXPECT_LT(force.rowwise().sum().norm(), TypeParam::rounding * at_faces);
  if (!TypeParam::whole_energy) return;
  const Response<2> response = respond<2>(turn(angle) * stretch() - Mat<2>::Identity(), block.material());
  EXPECT_NEAR(sample.energy() / (response.energy * block.area()), 1, 1e-11);
}

TYPED_TEST(DeformableBody, RotationByARightAngleCostsNoEnergyAndNoForce) {
  const Block block;
  TypeParam sample(block);
  const double quarter = std::numbers::pi / 2;
  sample.deform((turn(quarter) - Mat<2>::Identity()) * sample.sites(), quarter);
  const double E = block.material().young_modulus;
  EXPECT_LT(sample.energy(), 1e-26 * E * block.area());  // the square of rounding, 1e-15 of 24 l0 over l0
  EXPECT_LT(sample.force().cwiseAbs().maxCoeff(), 1e-12 * E * l0);
}

TYPED_TEST(DeformableBody, ForceIsTheDerivativeOfTheEnergy) {
  TypeParam sample(Block{.columns = 8, .rows = 12, .clamped = true});
  const Field X = sample.sites(), u = bent(X);
  sample.deform(u, 0.05);
  const Field force = sample.force();
  const double step = 1e-7;  // central differences: rounding of the energy over 1e-7 m, 1e-8 of the force
  int checked = 0;
  for (Eigen::Index n = 0; n < X.cols(); n += 5) {
    if (sample.held(n)) continue;
    for (int k = 0; k < 2; ++k) {
      Field plus = u, minus = u;
      plus(k, n) += step;
      minus(k, n) -= step;
      sample.deform(plus, 0.05);
      const double above = sample.energy();
      sample.deform(minus, 0.05);
      EXPECT_NEAR((above - sample.energy()) / (2 * step), -force(k, n), 1e-7 * force.cwiseAbs().maxCoeff())
          << n;
      ++checked;
    }
  }
  EXPECT_GT(checked, 10);
}

template <typename Sample>
void expect_kept_momenta(Sample sample) {
  const Field X = sample.sites();
  Field v(2, X.cols());
  // Turns, drifts, and is torn apart lengthwise.
  for (Eigen::Index n = 0; n < X.cols(); ++n)
    v.col(n) << 0.2 - 60 * X(1, n), 0.1 + 60 * X(0, n) + 30 * X(1, n);
  sample.launch(v);
  const Vec<3> before = sample.momenta();
  ASSERT_TRUE(sample.fly());
  EXPECT_LT((sample.momenta() - before).cwiseQuotient(before).cwiseAbs().maxCoeff(), Sample::conserves);
}

TYPED_TEST(DeformableBody, AFreeOneKeepsItsMomenta) { expect_kept_momenta(TypeParam(Block{})); }

/// Frequencies [rad/s] of a free block of particles, ascending, from the differences of its forces.
Eigen::VectorXd frequencies(HamiltonianSample& sample) {
  const Field X = sample.sites();
  const Eigen::Index size = 2 * X.cols();
  Eigen::MatrixXd K(size, size);
  const double step = 1e-6 * l0;
  for (Eigen::Index i = 0; i < size; ++i) {
    Field u = Field::Zero(2, X.cols());
    u.data()[i] = step;
    sample.deform(u, 0);
    const Field force = sample.force();
    K.col(i) =
        -Eigen::Map<const Eigen::VectorXd>(force.data(), size) / (step * sample.body().particle_mass());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(0.5 * (K + K.transpose()),
                                                             Eigen::EigenvaluesOnly);
  return modes.eigenvalues().cwiseMax(0).cwiseSqrt();
}

TEST(HamiltonianBody, HasNoMotionThatCostsNothingButThoseOfARigidBody) {
  const Block block{.columns = 8, .rows = 12};
  HamiltonianSample sample(block);
  const fem::FemBody<2> elements(block.body(), 0, 0.002, block.material(), Vec<2>::Zero());
  const Eigen::VectorXd exact = modal::lowest_modes(elements, block.material(), 9).omega_squared.cwiseSqrt();
  const Eigen::VectorXd found = frequencies(sample);
  // Differences of forces leave 1e-6 of the highest.
  EXPECT_LT(found[2], 1e-3 * exact[3]);
  // A mode without energy would stand among these six; 8 particles are off by 9 % at most.
  for (int i = 3; i < 9; ++i) EXPECT_NEAR(found[i] / exact[i], 1, 0.1) << i;
}

TEST(HamiltonianBody, WithoutItsStabilisationHasMotionsThatCostNextToNothing) {
  // docs/tables/solid_zero_modes.csv: particles that move against their neighbours, which the gradient cannot
  // see.
  const Block block{.columns = 8, .rows = 12};
  HamiltonianSample with(block), without(block, 0);
  const double bending = frequencies(with)[3];
  EXPECT_LT(frequencies(without)[3], 0.1 * bending);
}

TEST(HamiltonianBody, StatesTheFrequencyOfItsFastestMotion) {
  HamiltonianSample sample(Block{.columns = 8, .rows = 12});
  const Eigen::VectorXd all = frequencies(sample);
  const double stated = sample.body().highest_frequency();
  EXPECT_GE(stated / all[all.size() - 1], 1 - 1e-6);  // forces are linear to 1e-6
  EXPECT_LE(stated / all[all.size() - 1], 1 + 1e-4);  // the tolerance it was found with
}

template <typename Sample>
class ExplicitBody : public testing::Test {};
using ExplicitSamples = testing::Types<CorrectedSample, PaperSample, HamiltonianSample,
                                       Rubber<CorrectedSample>, Rubber<HamiltonianSample>>;
TYPED_TEST_SUITE(ExplicitBody, ExplicitSamples, SampleNames);

TYPED_TEST(ExplicitBody, RunsBelowItsStableStepAndFailsAboveIt) {
  using Case = std::pair<double, double>;  // Poisson's ratio, viscosity
  for (const auto& [nu, viscosity] : {Case(0, 0), Case(0.3, 0), Case(0.45, 0), Case(0.49, 0), Case(0, 0.2),
                                      Case(0.3, 0.2), Case(0.49, 0.2)}) {
    const Block block{.columns = 6, .rows = 12, .clamped = true, .poisson_ratio = nu, .viscosity = viscosity};
    TypeParam below(block), above(block);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    Field v(2, below.sites().cols());
    for (Eigen::Index i = 0; i < v.size(); ++i) v.data()[i] = 1e-4 * unit(random);
    below.launch(v);
    above.launch(v);
    // Ten periods of the block's first mode, 90 Hz, are 4000 steps at most.
    below.advance(8000, 0.95);
    // This near the limit the shortest motions are drawn out three times; a fault would have grown without
    // bound.
    EXPECT_LT(below.body().velocity().cwiseAbs().maxCoeff(), 0.01) << "nu = " << nu;
    above.advance(1000, 1.3);
    const Field wild = above.body().velocity();
    EXPECT_FALSE(wild.allFinite() && wild.cwiseAbs().maxCoeff() < block.material().pressure_speed()) << nu;
  }
}

TYPED_TEST(ExplicitBody, AViscousOneKeepsItsMomenta) {
  expect_kept_momenta(TypeParam(Block{.viscosity = 0.5}));
}

// A body that is undeformed and is being stretched with v has the stress that it would have, moved by tau v
// (S40).
TYPED_TEST(ExplicitBody, ViscousForcesAreThoseOfTheMotionInTheRetardationTime) {
  const Block block{.columns = 8, .rows = 12, .poisson_ratio = TypeParam::poisson_ratio, .viscosity = 0.5};
  const double tau = substance_of(block).retardation;
  TypeParam moving(block), moved(block);
  const Field v = 1e-3 * (stretch() - Mat<2>::Identity()) * moving.sites();  // tau v is a strain of 1e-9
  moving.launch(v);
  constexpr double share = 1e-6;  // share of the stable step; 2e-6 of tau at most
  moving.advance(1, share);
  moved.deform(tau * v, 0);
  const Field gained =
      moving.body().particle_mass() / (share * moving.stable_step()) * (moving.body().velocity() - v);
  const Field expected = moved.force();
  EXPECT_GT(expected.norm(), 0);
  EXPECT_LT((gained - expected).norm(), 1e-4 * expected.norm());
}

TEST(MpsBody, DeformationGradientOfAnAffineMotionIsExact) {
  PaperSample sample(Block{});
  Mat<2> F;
  F << 1.2, 0.3, -0.1, 0.9;
  sample.deform((F - Mat<2>::Identity()) * sample.sites(), 0);
  for (std::size_t p = 0; p < sample.body().grid().positions().size(); ++p)
    EXPECT_LT((sample.body().deformation_gradient(p) - F).norm(), 1e-13);  // rounding of positions of 24 l0
}

}  // namespace
}  // namespace cosurge::test
