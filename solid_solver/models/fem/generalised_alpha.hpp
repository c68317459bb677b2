// Implicit time integration with chosen damping of the shortest oscillations.
#pragma once

#include <Eigen/SparseCholesky>

#include "common/state_bytes.hpp"
#include "solid_solver/models/fem/fem_body.hpp"

namespace cosurge::fem {

/// Constants of the generalised-alpha method (Chung & Hulbert 1993; docs/method_solid.md, S25): second order,
/// and for linear systems unconditionally stable. rho_infinity is the factor on the amplitude of infinitely
/// fast oscillations per step: 1 damps nothing, 0 all of them.
struct AlphaConstants {
  double alpha_m, alpha_f, beta, gamma;

  explicit AlphaConstants(double rho_infinity)
      : alpha_m((2 * rho_infinity - 1) / (rho_infinity + 1)),
        alpha_f(rho_infinity / (rho_infinity + 1)),
        beta(0.25 * (1 - alpha_m + alpha_f) * (1 - alpha_m + alpha_f)),
        gamma(0.5 - alpha_m + alpha_f) {}
};

/// Result of the Newton iteration of a step.
struct [[nodiscard]] NewtonReport {
  int iterations;
  double residual;        ///< over the largest force of the balance [-]
  double least_volume;    ///< smallest det F
  Eigen::Index flattest;  ///< element with the least volume
  bool converged;         ///< false as well where an element is turned inside out

  static constexpr double tolerance = 1e-10;  ///< relative residual
};

/// The motion of one body.
template <int dim>
class GeneralisedAlpha {
 public:
  /// @param damping_rate of all velocities [1/s]: a force -rate M v
  GeneralisedAlpha(const FemBody<dim>& body, double rho_infinity, double damping_rate);

  /// Where in a step, as a fraction of it, the load is taken.
  double load_instant() const { return 1 - constants_.alpha_f; }

  /// Sets the acceleration at the start of the first step, in balance with the load [N]; later calls do
  /// nothing.
  void start(const Vector& load);

  /// One step of dt [s] under a load [N], by Newton's method with a direct solver. It converges when the
  /// residual is below the tolerance times the largest force, or below the rounding error of the forces of a
  /// body that moves freely by a large displacement. The factors of the last tangent are reused while they
  /// converge. The state is invalid if the report says that the step did not converge.
  NewtonReport step(const Vector& load, double dt);

  const Vector& displacement() const { return u_; }  ///< [m]
  const Vector& velocity() const { return v_; }      ///< [m/s]

  /// Sets the motion; the next step computes the acceleration anew.
  void place(const Vector& displacement, const Vector& velocity);

  void save(StateWriter& state) const;
  void restore(StateReader& state);

 private:
  enum class Tangent { kept, fresh };  // factors of an earlier tangent, or a new tangent in every iteration

  Vector coasting(double dt) const;  // next displacement without the part of the next acceleration
  NewtonReport balance(const Vector& external, double dt, Tangent tangent, Vector& a);
  bool factorize(const Vector& u, double dt);

  const FemBody<dim>& body_;
  AlphaConstants constants_;
  double damping_rate_;
  double stiffness_;  // largest diagonal entry of the undeformed body's stiffness [N/m]
  Eigen::SimplicialLDLT<Matrix> solver_;
  Vector u_, v_, a_;
  Vector tangent_at_;      // displacement of the factorised tangent; tangent_dt_ is its step
  double tangent_dt_ = 0;  // 0: there are none
  bool started_ = false;
};

}  // namespace cosurge::fem
