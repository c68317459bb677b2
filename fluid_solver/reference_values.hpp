// Constants of the weight function on the full lattice.
#pragma once

namespace cosurge::fluid {

/// Sums over the neighbours of a particle of the full lattice (docs/method.md, Weights and reference values).
struct ReferenceValues {
  double n0;           ///< number density, eq. (2) [-]
  double lambda0;      ///< Laplacian coefficient sum(r^2 w) / sum(w), eq. (3) [m2]
  double smooth0;      ///< smooth density, eq. (2b), the particle itself counted [-]
  double face_factor;  ///< sum(x^2 w) / (l0 sum(|x| w)) for a coordinate x, eq. (10c) [-]
};

/// Sums over the neighbours of a site of the infinite square or cubic lattice; `re` and `spacing` in metres.
/// Sites on the edge r = r_e do not count.
template <int dim>
ReferenceValues reference_values(double re, double spacing);

}  // namespace cosurge::fluid
