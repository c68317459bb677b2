#include "solid_solver/models/fem/chosen_grid.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "solid_solver/shape_moments.hpp"

namespace cosurge::fem {
namespace {

// A column of this many elements has five across its width, and its factorised stiffness matrix takes 0.13
// GB. Three times as many elements take four times the memory and twenty times the time.
constexpr double usual_elements = 250;
constexpr double shorter = 0.8;  // factor on the side, where the elements cannot be fitted to the outline

}  // namespace

template <int dim>
FittedGrid<dim> chosen_grid(const Shape<dim>& shape, double longest, int body) {
  if (longest > 0 || dim == 2 || shape.is_box()) return FittedGrid<dim>(shape, longest, body);
  const ShapeMoments<dim> moments(shape);
  const double finest = 2 * moments.volume / moments.surface / 3;
  double side = std::cbrt(moments.volume / usual_elements);
  for (; side > finest; side *= shorter) {
    try {
      return FittedGrid<dim>(shape, side, body);
    } catch (const Error&) {
      // The elements fall into parts, are inverted or miss the volume: shorter ones may fit.
    }
  }
  return FittedGrid<dim>(shape, finest, body);
}

template FittedGrid<2> chosen_grid(const Shape<2>&, double, int);
template FittedGrid<3> chosen_grid(const Shape<3>&, double, int);

}  // namespace cosurge::fem
