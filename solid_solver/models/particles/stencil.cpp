#include "solid_solver/models/particles/stencil.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cosurge::particles {
namespace {

constexpr double on_the_edge = 1e-9;  // of a spacing: rounding must not decide whether a site lies at r_e

// Of omega^2: where neighbours are missing, dilatation is stiffer than in the lattice. Blocks of 12 x 24
// particles with Poisson's ratios up to 0.495 became unstable at 0.939 of the lattice's step at worst (r_e
// from 1.5 to 3.1 l0).
constexpr double faces = 1.15;

/// Calls visit(k) for all k with lower <= k_a <= upper, the first coordinate fastest.
template <int dim, typename Visit>
void for_each_index(long lower, long upper, const Visit& visit) {
  SiteIndex<dim> k = SiteIndex<dim>::Constant(lower);
  for (int axis = 0; axis < dim;) {
    visit(k);
    for (axis = 0; axis < dim && ++k[axis] > upper; ++axis) k[axis] = lower;
  }
}

/// omega^2 of a plane wave without rotation, polarised along the gradient of its dilatation (S13).
template <int dim>
double pressure_wave(const Stencil<dim>& stencil, const Elasticity& material, const Vec<dim>& wave_vector) {
  double springs = 0;
  Vec<dim> dilatation = Vec<dim>::Zero();
  for (const Neighbor<dim>& n : stencil.neighbors) {
    const double scale = n.w / (n.length * n.length);
    springs += scale * (1 - std::cos(wave_vector.dot(n.r0)));
    dilatation += scale * std::sin(wave_vector.dot(n.r0)) * n.r0;
  }
  const double d_n0 = dim / stencil.n0;
  return (4 * d_n0 * material.mu() * springs + material.lambda() * d_n0 * d_n0 * dilatation.squaredNorm()) /
         material.density;
}

}  // namespace

double weight(double r, double re) { return r < re ? re / r - 1 : 0; }

template <int dim>
Stencil<dim> full_stencil(double spacing, double re) {
  Stencil<dim> stencil{.spacing = spacing, .neighbors = {}, .n0 = 0, .reach = 0};
  const long span = static_cast<long>(std::ceil(re));
  for_each_index<dim>(-span, span, [&](const SiteIndex<dim>& k) {
    const double r = k.template cast<double>().norm();
    if (r == 0 || r > re - on_the_edge) return;
    const double w = weight(r, re);
    stencil.neighbors.push_back(
        {.offset = k, .r0 = k.template cast<double>() * spacing, .length = r * spacing, .w = w});
    stencil.n0 += w;
    stencil.reach = std::max(stencil.reach, static_cast<int>(k.cwiseAbs().maxCoeff()));
  });
  return stencil;
}

template <int dim>
double highest_frequency(const Stencil<dim>& stencil, const Elasticity& material) {
  const double c_l0 = material.shear_speed() / stencil.spacing;
  double square = 24 * c_l0 * c_l0;
  constexpr int points =
      64;  // along each axis of the quarter of the Brillouin zone: misses the maximum by < 0.1 %
  for_each_index<dim>(0, points, [&](const SiteIndex<dim>& k) {
    const Vec<dim> wave_vector = k.template cast<double>() * (std::numbers::pi / points / stencil.spacing);
    square = std::max(square, faces * pressure_wave(stencil, material, wave_vector));
  });
  return std::sqrt(square);
}

template Stencil<2> full_stencil<2>(double, double);
template Stencil<3> full_stencil<3>(double, double);
template double highest_frequency<2>(const Stencil<2>&, const Elasticity&);

}  // namespace cosurge::particles
