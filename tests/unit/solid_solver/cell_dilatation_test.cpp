#include "solid_solver/models/particles/cell_dilatation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "tests/support/solid_cases.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::particles {
namespace {

using test::l0;

constexpr Elasticity rubber = {.density = 1100, .young_modulus = 1e6, .poisson_ratio = 0.49};

/// A block of 7 particles along each axis, with a notch, clear of the origin.
template <int dim>
struct Notched {
  static BodyGrid<dim> grid() {
    v1::Body body;
    test::set_box(*body.mutable_box(), std::vector<double>(dim, 3 * l0), std::vector<double>(dim, 10 * l0));
    return {test::body_of<dim>(body), 0, full_stencil<dim>(l0, 2.1)};
  }

  BodyGrid<dim> particles = grid();
  Slots members = Slots::Zero(particles.slots());
  std::array<Slots, dim> u, still;
  std::vector<Eigen::Index> inside;

  Notched() {
    u.fill(members);
    still.fill(members);
    for (std::size_t p = 0; p < particles.positions().size(); ++p) {
      if ((particles.positions()[p].array() > 7 * l0).all()) continue;
      inside.push_back(particles.slot(p));
      members[particles.slot(p)] = 1;
    }
  }

  Vec<dim> X(Eigen::Index slot) const {
    return particles.positions()[static_cast<std::size_t>(particles.particle_in(slot))];
  }
  void deform(const Mat<dim>& H) {
    for (const Eigen::Index i : inside)
      for (int k = 0; k < dim; ++k) u[k][i] = H.row(k).dot(X(i));
  }
  void scatter(double by) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-by, by);
    for (const Eigen::Index i : inside)
      for (int k = 0; k < dim; ++k) u[k][i] = unit(random);
  }
  CellDilatation<dim> cells() const { return {particles, members, l0, rubber}; }
  double energy(const CellDilatation<dim>& cells) const {  // over a particle's mass
    cells.measure(u, still, 0);
    double sum = 0;
    for (Eigen::Index i = particles.first_slot(); i < particles.last_slot(); i += BodyGrid<dim>::lanes)
      sum += cells.energy(i).sum();
    return sum;
  }
  Vec<dim> acceleration(const CellDilatation<dim>& cells, Eigen::Index slot) const {
    Vec<dim> a;
    for (int k = 0; k < dim; ++k) a[k] = cells.acceleration(slot)[k][0];
    return a;
  }
};

template <int dim>
void expect_the_continuums_energy() {
  Notched<dim> body;
  Mat<dim> H = Mat<dim>::Identity() * 0.03;
  H(0, 1) = 0.2;
  H(1, 0) = -0.1;
  body.deform(H);
  const double theta = H.trace() + 0.5 * H.squaredNorm();
  const double lambda = rubber.lambda() - lambda_of_particles(rubber);
  const double exact =
      0.5 * lambda / rubber.density * theta * theta * static_cast<double>(body.inside.size());
  EXPECT_NEAR(body.energy(body.cells()) / exact, 1, 1e-12);  // rounding
}

TEST(CellDilatation, OfUniformStrainHasTheContinuumsEnergyInTheWholeBody) {
  expect_the_continuums_energy<2>();
  expect_the_continuums_energy<3>();
}

template <int dim>
void expect_derivative() {
  Notched<dim> body;
  const CellDilatation<dim> cells = body.cells();
  body.scatter(0.2 * l0);
  body.energy(cells);
  std::vector<Vec<dim>> force;
  double scale = 0;
  for (const Eigen::Index i : body.inside) {
    force.push_back(body.acceleration(cells, i));
    scale = std::max(scale, force.back().norm());
  }
  const double step = 1e-8;  // central differences: rounding over 1e-8 m
  for (std::size_t n = 0; n < body.inside.size(); n += 5) {
    for (int k = 0; k < dim; ++k) {
      double& moved = body.u[k][body.inside[n]];
      moved += step;
      const double above = body.energy(cells);
      moved -= 2 * step;
      const double below = body.energy(cells);
      moved += step;
      EXPECT_NEAR((above - below) / (2 * step), -force[n][k], 1e-6 * scale) << n;
    }
  }
}

TEST(CellDilatation, ForceIsTheDerivativeOfItsEnergy) {
  expect_derivative<2>();
  expect_derivative<3>();
}

TEST(CellDilatation, ForcesHaveNeitherSumNorMoment) {
  Notched<3> body;
  const CellDilatation<3> cells = body.cells();
  body.scatter(0.2 * l0);
  body.energy(cells);
  Vec<3> sum = Vec<3>::Zero(), moment = sum;
  double gross = 0;
  for (const Eigen::Index i : body.inside) {
    const Vec<3> f = body.acceleration(cells, i);
    sum += f;
    moment += (body.X(i) + Vec<3>(body.u[0][i], body.u[1][i], body.u[2][i])).cross(f);
    gross += f.norm();
  }
  EXPECT_LT(sum.norm(), 1e-13 * gross);  // rounding
  EXPECT_LT(moment.norm(), 1e-13 * gross * 10 * l0);
}

TEST(CellDilatation, TakesNothingOfCommonPoissonsRatiosNorOfPlaneStress) {
  Elasticity material = rubber;
  material.poisson_ratio = 0.4;
  EXPECT_NEAR(lambda_of_particles(material), material.lambda(), 1e-9 * material.lambda());
  material.poisson_ratio = 0.499;
  EXPECT_LT(lambda_of_particles(material), 0.01 * material.lambda());
  material.plane_stress = true;
  EXPECT_EQ(lambda_of_particles(material), material.lambda());
}

}  // namespace
}  // namespace cosurge::particles
