#include "solid_solver/models/mps/mps_body.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/support/solid_cases.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::mps {
namespace {

using particles::full_stencil;
using particles::weight;
using test::l0;

struct Block {
  int columns = 12;
  int rows = 12;
  bool clamped = false;
  double young_modulus = 1e6;
  double poisson_ratio = 0.3;
  MpsParameters::Pairs pairs = MpsParameters::Pairs::paper;
};

using Axial = MpsBody<2>::Axial;

Elasticity material_of(const Block& block) {
  return {.density = 2500, .young_modulus = block.young_modulus, .poisson_ratio = block.poisson_ratio};
}

MpsBody<2> make_body(const Block& block) {
  const v1::Case c = test::plate({.columns = block.columns, .rows = block.rows, .clamped = block.clamped});
  return {test::body_of<2>(c.solid().body(0)),
          0,
          full_stencil<2>(l0, 2.1),
          {.material = material_of(block), .gravity = Vec<2>::Zero()},
          block.pairs};
}

double stable_step(const Block& block) { return 2 / make_body(block).highest_frequency(); }

Vec<2> turned(const Vec<2>& x, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * x[0] - s * x[1], s * x[0] + c * x[1]};
}

/// x = F X for all free particles, with rotation `angle` in the polar decomposition of F.
void deform(MpsBody<2>& body, const Mat<2>& F, double angle) {
  for (std::size_t p = 0; p < body.grid().positions().size(); ++p) {
    const Vec<2>& X = body.grid().positions()[p];
    body.place(p, F * X - X, Axial(angle), Vec<2>::Zero(), Axial(0));
  }
}

/// The sums of the method pair by pair, in the form of docs/method_solid.md.
Field pairwise_acceleration(const Block& block, const MpsBody<2>& body, const std::vector<double>& angle) {
  const Elasticity m = material_of(block);
  const Field q = body.displacement();
  const auto& X = body.grid().positions();
  const double n0 = full_stencil<2>(l0, 2.1).n0;
  const auto w = [](const Vec<2>& r0) { return weight(r0.norm() / l0, 2.1); };
  std::vector<double> dilatation(X.size(), 0.0);
  for (std::size_t i = 0; i < X.size(); ++i)
    for (std::size_t j = 0; j < X.size(); ++j) {
      const Vec<2> r0 = X[j] - X[i], r = r0 + q.col(j) - q.col(i);
      if (i != j) dilatation[i] += 2 / n0 * (r.norm() - r0.norm()) / r0.norm() * w(r0);
    }
  Field a = Field::Zero(2, q.cols());
  for (std::size_t i = 0; i < X.size(); ++i)
    for (std::size_t j = 0; j < X.size(); ++j) {
      if (i == j) continue;
      const Vec<2> r0 = X[j] - X[i], r = r0 + q.col(j) - q.col(i);
      const Vec<2> u = r - turned(r0, (angle[i] + angle[j]) / 2);
      const double pressures = -m.lambda() * (dilatation[i] + dilatation[j]);
      const double scale = 4 / n0 * 2 * m.mu() / r0.squaredNorm();
      const double pull = 2 / n0 * pressures / (r.norm() * r0.norm());
      for (int k = 0; k < 2; ++k) a(k, i) += (scale * u[k] - pull * r[k]) * w(r0) / m.density;
    }
  return a;
}

TEST(MpsBody, AccelerationIsThePairSumOfTheMethod) {
  const Block block{.columns = 5, .rows = 7};
  MpsBody<2> body = make_body(block);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> angle;
  for (std::size_t p = 0; p < body.grid().positions().size(); ++p) {
    angle.push_back(unit(random));
    const double x = unit(random), y = unit(random);
    body.place(p, Vec<2>(0.3 * l0 * x, 0.3 * l0 * y), Axial(angle.back()), Vec<2>::Zero(), Axial(0));
  }
  const Field expected = pairwise_acceleration(block, body, angle);
  const double scale = expected.cwiseAbs().maxCoeff();
  EXPECT_LT((body.acceleration() - expected).cwiseAbs().maxCoeff(),
            1e-13 * scale);  // rounding of twelve terms
}

TEST(MpsBody, UniformStretchStoresTheContinuumsEnergyInTheInterior) {
  // E = 1/2 (lambda tr^2 + 2 mu strain : strain) per volume; bodies of two sizes differ by the interior alone
  // in the limit, here by what a ring of surface particles leaves out, so compare the second difference of a
  // growing block.
  const double strain = 1e-6;
  Mat<2> F = Mat<2>::Identity();
  F(0, 0) += strain;
  double energy[3];
  for (int k = 0; k < 3; ++k) {
    const Block block{.columns = 10 + 4 * k, .rows = 10 + 4 * k};
    MpsBody<2> body = make_body(block);
    deform(body, F, 0);
    energy[k] = body.energies(0).elastic;
  }
  const Elasticity m = material_of({});
  const double second_difference = energy[2] - 2 * energy[1] + energy[0];
  const double volume = 2 * 16 * l0 * l0;  // second difference of (10 + 4 k)^2
  // The springs carry mu strain^2 and lambda / 2 tr^2 by n0; nonlinear terms are of the order of the strain.
  EXPECT_NEAR(second_difference / (0.5 * (m.lambda() + 2 * m.mu()) * strain * strain * volume), 1, 1e-5);
}

TEST(MpsBody, EnergyOfAFreeBodyIsConserved) {
  for (const double nu : {0.0, 0.3}) {
    const Block block{.poisson_ratio = nu};
    MpsBody<2> body = make_body(block);
    // A smooth motion, which the scheme resolves: the longest standing wave of the block.
    for (std::size_t p = 0; p < body.grid().positions().size(); ++p) {
      const Vec<2>& X = body.grid().positions()[p];
      body.place(p, Vec<2>::Zero(), Vec<2>(0.3 * std::cos(std::numbers::pi * X[0] / (12 * l0)), 0));
    }
    const double dt = 0.2 * stable_step(block);
    const Energies start = body.energies(dt);
    body.advance(5000, dt);
    const Energies end = body.energies(dt);
    // The scheme's own invariant differs from the energy by (omega dt)^2 / 8 of each wave: 2 % of the
    // shortest ones, which carry a tenth of the energy at most.
    EXPECT_NEAR((end.kinetic + end.elastic) / (start.kinetic + start.elastic), 1, 2e-3);
  }
}

/// Period [s] of the longest longitudinal standing wave of a free bar, from its crossings of zero.
double bar_period(const Block& block, double dt, int crossings_wanted) {
  MpsBody<2> body = make_body(block);
  const double length = block.rows * l0;
  for (std::size_t p = 0; p < body.grid().positions().size(); ++p) {
    const double shape = std::cos(std::numbers::pi * body.grid().positions()[p][1] / length);
    body.place(p, Vec<2>(0, 1e-5 * l0 * shape), Vec<2>::Zero());
  }
  const auto amplitude = [&] {
    const Field q = body.displacement();
    double sum = 0;
    for (Eigen::Index p = 0; p < q.cols(); ++p)
      sum += q(1, p) *
             std::cos(std::numbers::pi * body.grid().positions()[static_cast<std::size_t>(p)][1] / length);
    return sum;
  };
  std::vector<double> crossings;
  double last = amplitude();
  for (int k = 1; static_cast<int>(crossings.size()) < crossings_wanted; ++k) {
    body.advance(1, dt);
    const double now = amplitude();
    if (last * now < 0) crossings.push_back((k - now / (now - last)) * dt);
    last = now;
  }
  return 2 * (crossings.back() - crossings.front()) / (crossings_wanted - 1);
}

/// Speed [m/s] from the half periods of bars of two lengths: their difference does not depend on the soft
/// ends.
double bar_speed(int columns) {
  double half_period[2];
  for (int k = 0; k < 2; ++k) {
    const Block block{.columns = columns, .rows = 60 * (k + 1), .poisson_ratio = 0};
    half_period[k] = bar_period(block, 0.5 * stable_step(block), 5) / 2;
  }
  return 60 * l0 / (half_period[1] - half_period[0]);
}

TEST(MpsBody, BarWavesTravelAtTheirSpeed) {
  // Poisson's ratio zero: sqrt(E / rho). Side faces are soft, as the reference density counts neighbours that
  // they lack: c^2 width grows by c_0^2 with every column more, and bars of two widths tell c_0.
  const double narrow = bar_speed(12), wide = bar_speed(24);
  const double speed = std::sqrt((24 * wide * wide - 12 * narrow * narrow) / 12);
  RecordProperty("speed", std::to_string(speed));
  // Dispersion of a wave of 120 spacings, (k l0)^2 / 24 = 1e-4, and what is left of the ends.
  EXPECT_NEAR(speed / material_of({.poisson_ratio = 0}).pressure_speed(), 1, 0.005);
}

}  // namespace
}  // namespace cosurge::mps
