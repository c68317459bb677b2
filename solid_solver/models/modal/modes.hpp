// The lowest modes of vibration of a body.
#pragma once

#include "solid_solver/models/fem/fem_body.hpp"

namespace cosurge::modal {

/// K phi = omega^2 M phi about the undeformed body: squares of angular frequencies, ascending, and shapes.
struct Modes {
  Eigen::VectorXd omega_squared;  ///< [1/s2]; 0 for the motions of a free body as a whole
  Eigen::MatrixXd shapes;         ///< unknowns x modes, phi^T M phi = 1 [kg^-1/2]
};

/// The `count` lowest modes, by Lanczos iteration on the inverse of K - sigma M with sigma < 0, which is
/// positive definite for free bodies too (docs/method_solid.md, S26).
/// @throws Error for a body with fewer unknowns, NumericalError where the iteration does not converge
template <int dim>
Modes lowest_modes(const fem::FemBody<dim>& body, const Elasticity& material, int count);

/// The `count` lowest modes of body b, or all but one if it has fewer, by the elements of the model `fem`.
template <int dim>
Modes lowest_of_body(const Structure<dim>& structure, std::size_t b, int count);

}  // namespace cosurge::modal
