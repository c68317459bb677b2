#include "solid_solver/models/fem/generalised_alpha.hpp"

#include <cmath>

namespace cosurge::fem {
namespace {

constexpr double tolerance = 1e-10;  // of the gross forces, whose rounding is 1e-14
constexpr int most_iterations = 30;

double largest(const Vector& x) { return x.size() == 0 ? 0 : x.template lpNorm<Eigen::Infinity>(); }

}  // namespace

template <int dim>
GeneralisedAlpha<dim>::GeneralisedAlpha(const FemBody<dim>& body, double rho_infinity)
    : body_(body),
      constants_(rho_infinity),
      u_(Vector::Zero(body.unknowns())),
      v_(Vector::Zero(body.unknowns())),
      a_(Vector::Zero(body.unknowns())) {
  solver_.analyzePattern(body.mass());
}

template <int dim>
void GeneralisedAlpha<dim>::start(const Vector& load) {
  if (started_) return;
  solver_.factorize(body_.mass());
  a_ = solver_.solve(load + body_.weight() - body_.internal_force(u_).force);
  started_ = true;
}

template <int dim>
NewtonReport GeneralisedAlpha<dim>::step(const Vector& load, double dt) {
  const auto& [alpha_m, alpha_f, beta, gamma] = constants_;
  const Vector external = load + body_.weight();
  const Vector coasting = u_ + dt * v_ + dt * dt * (0.5 - beta) * a_;
  // Starts from the displacement before: a stiff body's acceleration tells nothing of its next one.
  Vector a = (u_ - coasting) / (beta * dt * dt);
  NewtonReport report{.iterations = 0, .residual = 0, .least_volume = 1, .converged = false};
  while (true) {
    const Vector u = (1 - alpha_f) * (coasting + beta * dt * dt * a) + alpha_f * u_;
    const auto internal = body_.internal_force(u);
    const Vector inertia = body_.momentum((1 - alpha_m) * a + alpha_m * a_);
    const Vector residual = external - internal.force - inertia;
    const double gross = std::max({internal.gross, largest(external), largest(inertia)});
    report.residual = gross > 0 ? largest(residual) / gross : 0;
    report.least_volume = internal.least_volume;
    report.converged = report.residual <= tolerance && internal.least_volume > 0;
    // The first pass is a linear step at least: forces that are small beside the gross ones move the body
    // too.
    const bool settled = report.residual <= tolerance && report.iterations > 0;
    if (settled || gross == 0 || !std::isfinite(residual.sum()) || report.iterations == most_iterations)
      break;
    Matrix system = body_.tangent(u);
    system.coeffs() =
        (1 - alpha_f) * beta * dt * dt * system.coeffs() + (1 - alpha_m) * body_.mass().coeffs();
    solver_.factorize(system);
    if (solver_.info() != Eigen::Success) break;
    a += solver_.solve(residual);
    ++report.iterations;
  }
  u_ = coasting + beta * dt * dt * a;
  v_ += dt * ((1 - gamma) * a_ + gamma * a);
  a_ = a;
  return report;
}

template <int dim>
void GeneralisedAlpha<dim>::place(const Vector& displacement, const Vector& velocity) {
  u_ = displacement;
  v_ = velocity;
  started_ = false;
}

template <int dim>
void GeneralisedAlpha<dim>::save(StateWriter& state) const {
  for (const Vector* values : {&u_, &v_, &a_}) state.put(*values);
  state.put(started_);
}

template <int dim>
void GeneralisedAlpha<dim>::restore(StateReader& state) {
  for (Vector* values : {&u_, &v_, &a_}) state.get(*values);
  state.get(started_);
}

template class GeneralisedAlpha<2>;

}  // namespace cosurge::fem
