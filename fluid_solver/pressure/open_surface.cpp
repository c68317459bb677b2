#include "fluid_solver/pressure/open_surface.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "common/error.hpp"
#include "fluid_solver/weight.hpp"

namespace cosurge::fluid {
namespace {

/// Sums over the lattice sites of one layer, at a height of some spacings above a particle.
struct Layer {
  double weights = 0;  ///< sum of w, eq. (1)
  double smooth = 0;   ///< sum of the shares in the smooth density, eq. (2b)
};

template <int dim>
Layer layer_at(int height, double re) {
  const int reach = static_cast<int>(std::ceil(re));
  Layer layer;
  for (int i = -reach; i <= reach; ++i)
    for (int j = dim == 3 ? -reach : 0; j <= (dim == 3 ? reach : 0); ++j) {
      const double r = std::sqrt(static_cast<double>(i * i + j * j + height * height));
      if (r >= re * (1 - 1e-9)) continue;
      layer.weights += weight(r, re);
      layer.smooth += smooth_share(weight(r, re));
    }
  return layer;
}

}  // namespace

template <int dim>
OpenSurface OpenSurface::on_lattice(double re, double spacing, double smooth0) {
  std::vector<Layer> above = {{}};  // by height in spacings
  for (int height = 1; height < re / spacing; ++height) above.push_back(layer_at<dim>(height, re / spacing));
  require(above.size() > 1 && re / spacing >= 1.5,
          "the radius of the Laplacian, {} spacings, must be at least 1.5 spacings", re / spacing);
  // The hydrostatic pressure is (layer + 1/2) rho g l0 in the layers 0, 1, ... below the surface. The matrix
  // row of a layer is exact if its weight times this pressure equals the residual of the weights of the other
  // layers.
  double lever = 0;  // sum of height x weight of the layers below
  for (std::size_t k = 1; k < above.size(); ++k) lever += static_cast<double>(k) * above[k].weights;
  std::array<double, 2> lack{}, needed{};
  for (std::size_t k = 1; k < above.size(); ++k) {
    lack[0] += above[k].smooth / smooth0;
    if (k > 1) lack[1] += above[k].smooth / smooth0;
  }
  needed[0] = lever / 0.5;
  needed[1] = (lever - above[1].weights) / 1.5;
  const double first = lack[0] - tolerance;
  const double second = lack[1] - tolerance;
  if (second <= 0) return {needed[0] / first, 0};  // the radius reaches the air from one layer only
  const double curvature = (needed[0] / first - needed[1] / second) / (first - second);
  return {needed[0] / first - curvature * first, curvature};
}

template OpenSurface OpenSurface::on_lattice<2>(double, double, double);
template OpenSurface OpenSurface::on_lattice<3>(double, double, double);

}  // namespace cosurge::fluid
