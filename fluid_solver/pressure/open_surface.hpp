// The free surface in the pressure equation: how strongly missing water ties a particle to P = 0.
#pragma once

namespace cosurge::fluid {

/// A particle beside the free surface lacks neighbours. In their place is air, P = 0. So its row in the
/// pressure equation gets an additional weight on the diagonal, which grows smoothly with the missing
/// density: eq. (11b). No particle jumps between surface and interior, and P = 0 lies half a spacing above
/// the centres of the outermost particles, which is the surface.
class OpenSurface {
 public:
  /// Fits the weight to the lattice, where it makes the hydrostatic pressure of water with a level surface
  /// exact in the two outermost layers. `re` is the radius of the Laplacian; `re` and `spacing` in metres;
  /// `smooth0` is the smooth density of the full lattice, eq. (2b).
  /// @throws Error when re is below 1.5 spacings: a second layer would not see air.
  template <int dim>
  static OpenSurface on_lattice(double re, double spacing, double smooth0);

  /// Weight towards P = 0, in units of w of eq. (1). `lack` is the missing share of the smooth density, eq.
  /// (2b), 1 - s / s_0, where walls and bodies count as present.
  double weight(double lack) const {
    const double beyond = lack - tolerance;
    return beyond > 0 ? beyond * (slope_ + curvature_ * beyond) : 0;
  }

  /// Lack that disorder alone makes: five times the 0.2 % by which it moves the smooth density.
  static constexpr double tolerance = 0.01;

 private:
  OpenSurface(double slope, double curvature) : slope_(slope), curvature_(curvature) {}

  double slope_, curvature_;
};

}  // namespace cosurge::fluid
