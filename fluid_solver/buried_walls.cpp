#include "fluid_solver/buried_walls.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge::fluid {

template <int dim>
void bury_walls(Particles<dim>& particles, const Box<dim>& tank, const std::vector<BodySites<dim>>& bodies,
                double reach, double spacing) {
  const double cells = std::ceil(reach / spacing);
  const Vec<dim> span = Vec<dim>::Constant(cells * spacing);
  const std::vector<Vec<dim>> around = fill(Box<dim>(-span, span + Vec<dim>::Constant(spacing)), spacing);
  const auto in_body = [&](const Vec<dim>& x) {
    return std::any_of(bodies.begin(), bodies.end(), [&](const auto& body) { return body.contains(x); });
  };
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::wall) continue;
    bool wet = false, buried = false;
    for (const Vec<dim>& site : around) {
      const Vec<dim> way = site.array() - 0.5 * spacing, x = particles.x[i] + way;
      if (way.norm() > reach || !tank.contains(x)) continue;
      (in_body(x) ? buried : wet) = true;
    }
    if (buried && !wet) particles.kind[i] = Kind::dummy;
  }
}

template void bury_walls<2>(Particles<2>&, const Box<2>&, const std::vector<BodySites<2>>&, double, double);
template void bury_walls<3>(Particles<3>&, const Box<3>&, const std::vector<BodySites<3>>&, double, double);

}  // namespace cosurge::fluid
