#include "solid_solver/models/particles/stencil.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge::particles {
namespace {

constexpr double on_the_edge = 1e-9;  // [spacings] tolerance for sites at r_e

/// Calls visit(k) for all k with lower <= k_a <= upper, the first coordinate fastest.
template <int dim, typename Visit>
void for_each_index(long lower, long upper, const Visit& visit) {
  SiteIndex<dim> k = SiteIndex<dim>::Constant(lower);
  for (int axis = 0; axis < dim;) {
    visit(k);
    for (axis = 0; axis < dim && ++k[axis] > upper; ++axis) k[axis] = lower;
  }
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

template Stencil<2> full_stencil<2>(double, double);
template Stencil<3> full_stencil<3>(double, double);

}  // namespace cosurge::particles
