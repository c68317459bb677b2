#include "solid_solver/models/automatic/linear_theory.hpp"

#include "common/error.hpp"

namespace cosurge::automatic {

template <int dim>
LinearTheory<dim>::LinearTheory(const fem::FemBody<dim>& body)
    : body_(body), stiffness_(body.tangent(fem::Vector::Zero(body.unknowns()))) {
  solver_.compute(stiffness_);
  if (solver_.info() != Eigen::Success)
    throw NumericalError("solid: the stiffness of the undeformed body cannot be factorised");
}

template <int dim>
fem::Vector LinearTheory<dim>::correction(const fem::Vector& u) const {
  const fem::Vector linear = stiffness_.template selfadjointView<Eigen::Lower>() * u;
  return solver_.solve(linear - body_.internal_force(u).force);
}

template class LinearTheory<2>;
template class LinearTheory<3>;

}  // namespace cosurge::automatic
