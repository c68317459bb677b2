#include "solid_solver/models/fem/generalised_alpha.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cosurge::fem {
namespace {

// Tolerance relative to stiffness times displacement: forces of rigid motions have a rounding error of 4e-16
// of it, and accelerations are differences of displacements.
constexpr double rounding = 2e-14;
constexpr int most_iterations = 30;
constexpr double slow = 0.1;  // residual ratio of an iteration above which a new tangent, as costly as ten
                              // iterations, is computed
constexpr double near = 0.1;  // relative change of the step size up to which an old tangent is tried

double largest(const Vector& x) { return x.size() == 0 ? 0 : x.template lpNorm<Eigen::Infinity>(); }

}  // namespace

template <int dim>
GeneralisedAlpha<dim>::GeneralisedAlpha(const FemBody<dim>& body, double rho_infinity, double damping_rate)
    : body_(body),
      constants_(rho_infinity),
      damping_rate_(damping_rate),
      stiffness_(body.largest_stiffness()),
      u_(Vector::Zero(body.unknowns())),
      v_(Vector::Zero(body.unknowns())),
      a_(Vector::Zero(body.unknowns())),
      tangent_at_(Vector::Zero(body.unknowns())) {
  solver_.analyzePattern(body.mass());
}

template <int dim>
void GeneralisedAlpha<dim>::start(const Vector& load) {
  if (started_) return;
  solver_.factorize(body_.mass());
  tangent_dt_ = 0;
  a_ = solver_.solve(load + body_.weight() - body_.internal_force(u_).force) - damping_rate_ * v_;
  started_ = true;
}

template <int dim>
NewtonReport GeneralisedAlpha<dim>::step(const Vector& load, double dt) {
  const Vector external = load + body_.weight();
  const bool alike = std::abs(dt - tangent_dt_) <= near * dt;
  NewtonReport report{.iterations = 0, .residual = 0, .least_volume = 1, .flattest = 0, .converged = false};
  Vector a;
  if (alike) report = balance(external, dt, Tangent::kept, a);
  if (!report.converged) {
    const int in_vain = report.iterations;
    report = balance(external, dt, Tangent::fresh, a);
    report.iterations += in_vain;
  }
  u_ = coasting(dt) + constants_.beta * dt * dt * a;
  v_ += dt * ((1 - constants_.gamma) * a_ + constants_.gamma * a);
  a_ = a;
  return report;
}

template <int dim>
Vector GeneralisedAlpha<dim>::coasting(double dt) const {
  return u_ + dt * v_ + dt * dt * (0.5 - constants_.beta) * a_;
}

template <int dim>
NewtonReport GeneralisedAlpha<dim>::balance(const Vector& external, double dt, Tangent tangent, Vector& a) {
  const auto& [alpha_m, alpha_f, beta, gamma] = constants_;
  const Vector start = coasting(dt);
  // Starts from the previous displacement: the acceleration of a stiff body does not predict its next one.
  a = (u_ - start) / (beta * dt * dt);
  NewtonReport report{.iterations = 0, .residual = 0, .least_volume = 1, .flattest = 0, .converged = false};
  double before = std::numeric_limits<double>::infinity();
  while (true) {
    const Vector u = (1 - alpha_f) * (start + beta * dt * dt * a) + alpha_f * u_;
    const auto internal = body_.internal_force(u);
    const Vector v = v_ + (1 - alpha_f) * dt * ((1 - gamma) * a_ + gamma * a);
    const Vector inertia = body_.momentum((1 - alpha_m) * a + alpha_m * a_ + damping_rate_ * v);
    const Vector residual = external - internal.force - inertia;
    const double gross = std::max({internal.gross, largest(external), largest(inertia)});
    const double left = largest(residual);
    report.residual = gross > 0 ? left / gross : 0;
    report.least_volume = internal.least_volume;
    report.flattest = internal.flattest;
    const double accepted = std::max(NewtonReport::tolerance * gross, rounding * stiffness_ * largest(u));
    // At least one iteration: forces that are small compared with the largest one move the body too.
    const bool settled = gross == 0 || (left <= accepted && report.iterations > 0);
    report.converged = settled && internal.least_volume > 0;
    if (settled || !std::isfinite(residual.sum()) || report.iterations == most_iterations) return report;
    if (tangent == Tangent::kept && report.residual > slow * before) return report;
    if (tangent == Tangent::fresh && !factorize(u, dt)) return report;
    a += solver_.solve(residual);
    before = report.residual;
    ++report.iterations;
  }
}

template <int dim>
bool GeneralisedAlpha<dim>::factorize(const Vector& u, double dt) {
  const auto& [alpha_m, alpha_f, beta, gamma] = constants_;
  Matrix system = body_.tangent(u);
  const double inertia = 1 - alpha_m + (1 - alpha_f) * gamma * dt * damping_rate_;
  system.coeffs() = (1 - alpha_f) * beta * dt * dt * system.coeffs() + inertia * body_.mass().coeffs();
  solver_.factorize(system);
  tangent_at_ = u;
  tangent_dt_ = solver_.info() == Eigen::Success ? dt : 0;
  return tangent_dt_ > 0;
}

template <int dim>
void GeneralisedAlpha<dim>::place(const Vector& displacement, const Vector& velocity) {
  u_ = displacement;
  v_ = velocity;
  started_ = false;
}

template <int dim>
void GeneralisedAlpha<dim>::save(StateWriter& state) const {
  for (const Vector* values : {&u_, &v_, &a_, &tangent_at_}) state.put(*values);
  state.put(tangent_dt_);
  state.put(started_);
}

template <int dim>
void GeneralisedAlpha<dim>::restore(StateReader& state) {
  for (Vector* values : {&u_, &v_, &a_, &tangent_at_}) state.get(*values);
  state.get(tangent_dt_);
  state.get(started_);
  // Recomputes the factors, with the same bits as when the state was saved.
  if (tangent_dt_ > 0) factorize(Vector(tangent_at_), tangent_dt_);
}

template class GeneralisedAlpha<2>;
template class GeneralisedAlpha<3>;

}  // namespace cosurge::fem
