// How far a body is from the linear theory, and from a sum of its lowest modes.
#pragma once

#include <Eigen/SparseCholesky>
#include <optional>

#include "solid_solver/models/fem/fem_body.hpp"

namespace cosurge::automatic {

/// The stiffness K of an undeformed body that cannot move as a whole (docs/method_solid.md, section 14).
template <int dim>
class LinearTheory {
 public:
  /// @param body must outlive this. @throws NumericalError if the body can move as a whole.
  explicit LinearTheory(const fem::FemBody<dim>& body);

  /// (S48) Change of a displacement u [m] by one Newton step with K towards the nonlinear balance with the
  /// forces K u. It is too large for bodies that bend, because the linear displacement stretches them.
  fem::Vector correction(const fem::Vector& u) const;

  /// The nonlinear displacement [m] under the forces K u, by Newton's method to 0.1 % of u; nothing if it
  /// does not converge.
  std::optional<fem::Vector> nonlinear(const fem::Vector& u) const;

  /// Displacement under constant forces: K^-1 f [m].
  fem::Vector deflection(const fem::Vector& force) const { return solver_.solve(force); }

 private:
  fem::Vector force_of(const fem::Vector& u) const;  // K u

  const fem::FemBody<dim>& body_;
  fem::Matrix stiffness_;  // lower triangle
  Eigen::SimplicialLDLT<fem::Matrix> solver_;
};

}  // namespace cosurge::automatic
