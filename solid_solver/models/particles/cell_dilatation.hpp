// Resistance to changes of volume, measured in the cells between particles: bodies that are nearly
// incompressible do not lock.
#pragma once

#include <vector>

#include "solid_solver/elasticity.hpp"
#include "solid_solver/models/particles/body_grid.hpp"
#include "solid_solver/models/particles/lanes.hpp"

namespace cosurge::particles {

/// The part of lambda that acts on the dilatation of each particle [Pa]: at most 4 mu, which is all of lambda
/// up to Poisson's ratio 0.4 in space and plane strain, and always in plane stress. A bent plate has one
/// dilatation more through its thickness than differences of displacement, so that a large lambda at
/// particles would make it too stiff.
double lambda_of_particles(const Elasticity& material);

/// The remaining part of lambda. A cell lies between 2^dim particles that are neighbours along the axes; the
/// volume of each particle is shared equally among its cells. With the mean gradient H_c of a cell, from its
/// diagonals, the dilatation and the energy are (docs/method_solid.md, S42)
///   theta_c = tr(H_c) + H_c : H_c / 2,   E = sum_c (lambda_c / 2) V_c theta_c^2,
/// as in St. Venant-Kirchhoff's law under uniform strain. Forces are the exact derivative of the energy, so
/// that linear and angular momentum are conserved.
template <int dim>
class CellDilatation {
 public:
  using Vectors = std::array<Slots, dim>;

  /// @param members 1 or 0 for each slot: whether its particle can be a corner of cells
  CellDilatation(const BodyGrid<dim>& grid, const Slots& members, double spacing, const Elasticity& material);

  /// Measures all cells. The stress belongs to the displacement u + retardation * v (S40), its direction to
  /// the displacement u.
  void measure(const Vectors& u, const Vectors& v, double retardation) const;

  /// Acceleration of the particles in slots from i on, by the cells as measured [m/s2].
  LaneVec<dim> acceleration(Eigen::Index i) const;

  /// Energy of the cells whose first particles are in slots from i on, over a particle's mass [m2/s2].
  Lanes energy(Eigen::Index i) const { return 0.5 * at(stiffness_, i) * at(dilatation_, i).square(); }

 private:
  static constexpr int diagonals = 1 << (dim - 1);
  using Gradient = std::array<std::array<Lanes, dim>, dim>;

  /// From one corner of a cell to the opposite one.
  struct Diagonal {
    Eigen::Index from = 0, to = 0;    // shifts from the cell's first particle
    std::array<double, dim> along{};  // -1 or 1 on each axis
  };

  Gradient gradient(const Vectors& u, Eigen::Index i) const;
  void share_volumes(const BodyGrid<dim>& grid, const Slots& members);

  Eigen::Index first_, last_;  // slots
  double over_edges_;          // 1 / (2^(dim - 1) l0): gradient by the sum of a cell's diagonals [1/m]
  std::array<Diagonal, diagonals> diagonals_;
  Slots stiffness_;  // lambda_c / rho times the cell's volume in particles, at its first one [m2/s2]; 0: no
                     // cell
  mutable Slots dilatation_;                     // dilatation of each cell
  mutable std::array<Vectors, diagonals> pull_;  // acceleration of the ends of each diagonal [m/s2]
};

}  // namespace cosurge::particles
