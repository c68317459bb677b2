#include "solid_solver/models/mps/pair_weights.hpp"

#include <gtest/gtest.h>

#include "solid_solver/models/mps/mps_body.hpp"
#include "tests/support/solid_cases.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::mps {
namespace {

using test::l0;

template <int dim>
Body<dim> block(bool clamped) {
  v1::Body body;
  const double width = 7 * l0, height = 9 * l0;
  if constexpr (dim == 2) {
    test::set_box(*body.mutable_box(), {0, 0}, {width, height});
    if (clamped) test::set_box(*body.add_clamp(), {0, -4 * l0}, {width, 0});
  } else {
    test::set_box(*body.mutable_box(), {0, 0, 0}, {width, 5 * l0, height});
    if (clamped) test::set_box(*body.add_clamp(), {0, 0, -4 * l0}, {width, 5 * l0, 0});
  }
  return test::body_of<dim>(body);
}

template <int dim>
Elasticity material() {
  return {.density = 2500, .young_modulus = 1e6, .poisson_ratio = 0.3};
}

/// Largest relative deviation of sum w r r^T / |r|^2 of a free particle from the lattice's.
template <int dim>
double worst_moment(const PairWeights<dim>& weights, const particles::BodyGrid<dim>& grid,
                    const particles::Stencil<dim>& stencil) {
  const Mat<dim> whole = Mat<dim>::Identity() * stencil.n0 / dim;
  double worst = 0;
  for (std::size_t i = 0; i < grid.positions().size(); ++i) {
    Mat<dim> moment = Mat<dim>::Zero();
    for (std::size_t k = 0; k < stencil.neighbors.size(); ++k) {
      const Vec<dim> direction = stencil.neighbors[k].r0 / stencil.neighbors[k].length;
      const auto& pair = weights.pairs[k];
      const Eigen::Index slot = grid.slot(i);
      // A pair's dilatation over its own length: stretch times reach.
      moment += pair.stretch[slot] * pair.reach[slot] * direction * direction.transpose();
    }
    if (!grid.held(i)) worst = std::max(worst, (moment - whole).norm() / whole.norm());
  }
  return worst;
}

template <int dim>
void expect_whole_moments() {
  for (const bool clamped : {false, true}) {
    const auto stencil = particles::full_stencil<dim>(l0, 2.1);
    const particles::BodyGrid<dim> grid(block<dim>(clamped), 0, stencil);
    // The tolerance of the iteration, 1e-12 of the sum over all particles.
    EXPECT_LT(worst_moment(whole_weights(grid, stencil), grid, stencil), 1e-9) << dim << clamped;
    // A corner of the body has a quarter, an eighth of the lattice's neighbours.
    EXPECT_GT(worst_moment(lattice_weights(grid, stencil), grid, stencil), 0.5) << dim << clamped;
  }
}

TEST(PairWeights, EveryFreeParticleHasTheLatticesSecondMoment) {
  expect_whole_moments<2>();
  expect_whole_moments<3>();
}

TEST(PairWeights, PairsThatReachIntoAClampEndAtItsFace) {
  const auto stencil = particles::full_stencil<2>(l0, 2.1);
  const particles::BodyGrid<2> grid(block<2>(true), 0, stencil);
  const PairWeights<2> weights = whole_weights(grid, stencil);
  const auto reach = [&](double row, long steps) {
    const auto particle = static_cast<std::size_t>(grid.particle_at({3.5 * l0, row * l0}));
    for (std::size_t k = 0; k < stencil.neighbors.size(); ++k)
      if (stencil.neighbors[k].offset == particles::SiteIndex<2>(0, -steps))
        return weights.pairs[k].reach[grid.slot(particle)];
    return 0.0;
  };
  EXPECT_NEAR(reach(0.5, 1), 0.5, 1e-12);  // rounding of sites
  EXPECT_NEAR(reach(0.5, 2), 0.25, 1e-12);
  EXPECT_NEAR(reach(1.5, 2), 0.75, 1e-12);
  EXPECT_EQ(reach(2.5, 2), 1);
}

/// Energy of a free block under a small stress along the last axis alone, over the continuum's.
template <int dim>
double uniaxial_energy(MpsParameters::Pairs pairs) {
  const Elasticity m = material<dim>();
  MpsBody<dim> body(block<dim>(false), 0, particles::full_stencil<dim>(l0, 2.1),
                    {.material = m, .gravity = Vec<dim>::Zero()}, pairs);
  const double strain = 1e-6, nu = m.poisson_ratio;
  const double across = dim == 2 ? -nu / (1 - nu) : -nu;  // in the plane: plane strain
  for (std::size_t p = 0; p < body.grid().positions().size(); ++p) {
    Vec<dim> u = across * strain * body.grid().positions()[p];
    u[dim - 1] /= across;
    body.place(p, u, Vec<dim>::Zero());
  }
  const double modulus = dim == 2 ? m.young_modulus / (1 - nu * nu) : m.young_modulus;
  const double volume = static_cast<double>(body.particles()) * std::pow(l0, dim);
  return body.energies(0).elastic / (0.5 * modulus * strain * strain * volume);
}

TEST(PairWeights, ABodyUnderTensionHasTheContinuumsEnergyToItsCorners) {
  // Nonlinear terms are of the order of the strain, 1e-6.
  EXPECT_NEAR(uniaxial_energy<2>(MpsParameters::Pairs::corrected), 1, 1e-5);
  EXPECT_NEAR(uniaxial_energy<3>(MpsParameters::Pairs::corrected), 1, 1e-5);
  EXPECT_LT(uniaxial_energy<2>(MpsParameters::Pairs::paper), 0.95);
}

}  // namespace
}  // namespace cosurge::mps
