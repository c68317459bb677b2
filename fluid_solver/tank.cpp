#include "fluid_solver/tank.hpp"

namespace cosurge::fluid {

template <int dim>
void add_tank(Particles<dim>& particles, const Box<dim>& tank, int dummy_layers, double spacing) {
  const double thickness = (1 + dummy_layers) * spacing;
  Box<dim> outer = tank;
  outer.min.array() -= thickness;
  outer.max.template head<dim - 1>().array() += thickness;
  for (const Vec<dim>& x : fill(outer, spacing)) {
    if (tank.contains(x)) continue;
    const double depth =
        std::max((tank.min - x).maxCoeff(), (x - tank.max).template head<dim - 1>().maxCoeff());
    particles.add(depth < spacing ? Kind::wall : Kind::dummy, x);
  }
}

template <int dim>
Box<dim> tank_domain(const Box<dim>& tank, int dummy_layers, double spacing) {
  const double margin = (2 + dummy_layers) * spacing;
  Box<dim> domain = tank;
  domain.min.array() -= margin;
  domain.max.array() += margin;
  domain.max[dim - 1] += tank.max[dim - 1] - tank.min[dim - 1];
  return domain;
}

template void add_tank<2>(Particles<2>&, const Box<2>&, int, double);
template void add_tank<3>(Particles<3>&, const Box<3>&, int, double);
template Box<2> tank_domain<2>(const Box<2>&, int, double);
template Box<3> tank_domain<3>(const Box<3>&, int, double);

}  // namespace cosurge::fluid
