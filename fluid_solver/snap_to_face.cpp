#include "fluid_solver/snap_to_face.hpp"

#include <limits>

#include "common/error.hpp"

namespace cosurge::fluid {

template <int dim>
Vec<dim> snap_to_face(const std::string& probe, const Vec<dim>& position, const Interface& interface,
                      double spacing) {
  constexpr double rounding = 1e-6;  // [spacings]
  double least = std::numeric_limits<double>::infinity();
  Vec<dim> nearest = position;
  for (Eigen::Index k = 0; k < interface.points(); ++k) {
    const Vec<dim> centre = interface.position.col(k);
    for (int axis = 0; axis < dim; ++axis) {
      if (interface.area(axis, k) == 0) continue;
      const Vec<dim> half = Vec<dim>::Constant(0.5 * spacing);
      Vec<dim> on = position.cwiseMax(centre - half).cwiseMin(centre + half);
      on[axis] = centre[axis] + (interface.area(axis, k) > 0 ? 0.5 : -0.5) * spacing;
      const double distance = (on - position).norm();
      if (distance >= least - rounding * spacing) continue;
      least = distance;
      nearest = on;
    }
  }
  require(std::isfinite(least), "output.probe {}: no body has a wet face", probe);
  require(
      least <= spacing,
      "output.probe {}: the nearest wet face of a body is {:.3g} m away, at ({:.6g}), and a spacing is {} m: "
      "move the probe there",
      probe, least, fmt::join(nearest, ", "), spacing);
  return nearest;
}

template Vec<2> snap_to_face<2>(const std::string&, const Vec<2>&, const Interface&, double);
template Vec<3> snap_to_face<3>(const std::string&, const Vec<3>&, const Interface&, double);

}  // namespace cosurge::fluid
