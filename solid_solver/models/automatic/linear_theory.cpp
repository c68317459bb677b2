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
  return solver_.solve(force_of(u) - body_.internal_force(u).force);
}

template <int dim>
std::optional<fem::Vector> LinearTheory<dim>::nonlinear(const fem::Vector& u) const {
  constexpr int most_iterations = 12;
  constexpr double accurate = 1e-3;  // tolerance: last change over the displacement
  const fem::Vector force = force_of(u);
  fem::Vector x = u;
  Eigen::SimplicialLDLT<fem::Matrix> tangent;
  tangent.analyzePattern(stiffness_);
  for (int k = 0; k < most_iterations; ++k) {
    const auto internal = body_.internal_force(x);
    if (internal.least_volume <= 0) return {};
    tangent.factorize(body_.tangent(x));
    if (tangent.info() != Eigen::Success) return {};
    const fem::Vector change = tangent.solve(force - internal.force);
    x += change;
    if (!x.allFinite()) return {};
    if (change.template lpNorm<Eigen::Infinity>() <= accurate * u.template lpNorm<Eigen::Infinity>())
      return x;
  }
  return {};
}

template <int dim>
fem::Vector LinearTheory<dim>::force_of(const fem::Vector& u) const {
  return stiffness_.template selfadjointView<Eigen::Lower>() * u;
}

template class LinearTheory<2>;
template class LinearTheory<3>;

}  // namespace cosurge::automatic
