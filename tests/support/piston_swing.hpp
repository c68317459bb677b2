// Oscillation of the piston under a lumped water column with a coupling scheme.
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/piston_run.hpp"

namespace cosurge::testing {

/// Words of a coupling whose order is measured.
struct CouplingWords {
  v1::Coupling::Scheme scheme;
  v1::Coupling::Velocity velocity = v1::Coupling::end;
  v1::Coupling::LoadPath load = v1::Coupling::held;

  v1::Coupling message() const {
    v1::Coupling coupling;
    coupling.set_scheme(scheme);
    coupling.set_velocity(velocity);
    coupling.set_load(load);
    coupling.mutable_iteration()->set_tolerance(1e-11);
    return coupling;
  }
};

struct PistonSwing {
  double frequency;  ///< relative error of the frequency
  double lost;       ///< relative loss of amplitude per period
  double created;    ///< energy created by the scheme in a period, over the energy of the swing
};

/// The factor z from window to window of y_k = c + Re(a z^k), from y_(k+2) = 2 Re(z) y_(k+1) - |z|^2 y_k +
/// const by least squares. The fit begins at a window when the other modes of the scheme have decayed.
inline std::complex<double> window_factor(const std::vector<double>& y, std::size_t from) {
  const auto rows = static_cast<Eigen::Index>(y.size() - from - 2);
  Eigen::MatrixXd A(rows, 3);
  Eigen::VectorXd b(rows);
  for (Eigen::Index k = 0; k < rows; ++k) {
    const double* at = &y[from + static_cast<std::size_t>(k)];
    A.row(k) << at[1], at[0], 1;
    b[k] = at[2];
  }
  const Eigen::VectorXd c = A.colPivHouseholderQr().solve(b);
  return {c[0] / 2, std::sqrt(-c[1] - c[0] * c[0] / 4)};
}

/// Twelve periods with an added mass of `mu` times the piston's and `windows` a period.
inline PistonSwing piston_swing(const CouplingWords& words, double mu, int windows, int substeps) {
  const Piston piston{
      .mass = 500 / mu, .substeps = substeps, .tells_mode = words.scheme == v1::Coupling::weak_inertial};
  PistonRun run(piston, words.message(), 1 / (windows * piston.wet_frequency()));
  constexpr int periods = 12, quiet = 2;
  run.run(static_cast<std::size_t>(periods * windows));
  const std::vector<double>& y = run.history.height;
  const std::complex<double> z = window_factor(y, static_cast<std::size_t>(quiet * windows));
  const auto at = [&](int k) { return static_cast<std::size_t>(k); };
  // Energy at the turning points: k a^2 / 2 about the equilibrium.
  const double rest = -piston.gravity * piston.added_mass() / piston.stiffness;
  double high = 0;
  for (int k = quiet * windows; k < (quiet + 1) * windows; ++k) high = std::max(high, y[at(k)] - rest);
  const auto created = [&](int period) { return run.history.coupling[at(period * windows)][2]; };
  return {.frequency = std::arg(z) / (2 * std::numbers::pi) * windows - 1,
          .lost = 1 - std::pow(std::abs(z), windows),
          .created = (created(quiet + 1) - created(quiet)) / (0.5 * piston.stiffness * high * high)};
}

}  // namespace cosurge::testing
