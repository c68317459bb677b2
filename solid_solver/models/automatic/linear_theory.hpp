// How far a body is from the linear theory, and from a sum of its lowest modes.
#pragma once

#include <Eigen/SparseCholesky>

#include "solid_solver/models/fem/fem_body.hpp"

namespace cosurge::automatic {

/// The stiffness K of an undeformed body that cannot move as a whole (docs/method_solid.md, section 12).
template <int dim>
class LinearTheory {
 public:
  /// @param body must outlive this. @throws NumericalError if the body can move as a whole.
  explicit LinearTheory(const fem::FemBody<dim>& body);

  /// (S48) Change of a displacement [m] by one Newton step from the linear balance with the same forces:
  /// K^-1 (K u - f(u)).
  fem::Vector correction(const fem::Vector& u) const;

  /// Displacement under constant forces: K^-1 f [m].
  fem::Vector deflection(const fem::Vector& force) const { return solver_.solve(force); }

 private:
  const fem::FemBody<dim>& body_;
  fem::Matrix stiffness_;  // lower triangle
  Eigen::SimplicialLDLT<fem::Matrix> solver_;
};

}  // namespace cosurge::automatic
