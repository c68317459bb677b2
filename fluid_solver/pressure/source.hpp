// Source terms of the pressure equation.
#pragma once

namespace cosurge::fluid {

/// Input of the source term of one particle.
struct SourceInput {
  double density;             ///< fluid density rho [kg/m3]
  double dt;                  ///< [s]
  double deviation;           ///< (n - n0) / n0 of the predicted positions [-]
  double divergence = 0;      ///< divergence of the predicted velocities [1/s]
  double per_divergence = 0;  ///< change of the source per divergence [kg/(m3 s)]
};

/// Eq. (6a), as Amaro & Cheng: S = -gamma rho / dt^2 (n* - n0) / n0 (Koshizuka & Oka 1996). An undamped
/// spring on the density with the period 2 pi dt / sqrt(gamma): noise grows as dt shrinks.
inline double deviation_source(const SourceInput& in, double gamma) {
  return -gamma * in.density / (in.dt * in.dt) * in.deviation;
}

/// Eq. (6b): S = (1 - gamma) rho / dt div u* - gamma rho / dt^2 (n* - n0) / n0 (Tanaka & Masunaga 2010,
/// doi 10.1016/j.jcp.2010.02.011; Lee et al. 2011, doi 10.1016/j.cma.2010.12.001). The step ends free of
/// divergence; the density drifts back over 1 / gamma steps.
inline double mixed_source(const SourceInput& in, double gamma) {
  return in.per_divergence * in.divergence + deviation_source(in, gamma);
}

/// Rates of correction with the source `time_scale` [1/s].
struct Rates {
  double divergence;  ///< k_u, at most 1 / dt
  double density;     ///< k_n, at most k_u
  double bodies;      ///< k_b, of a divergence that bodies make by changing their velocity; at least k_u
};

/// Eq. (6c): S = rho k_u div u* - rho k_n^2 (n* - n0) / n0, after Cheng, Amaro & Favero 2021 (arXiv
/// 2203.08873), who use one rate c / l0 for both. The divergence decays at the rate k_u for any step, and the
/// density oscillates at k_n with the damping ratio k_u / (2 k_n). `density_rate` is k_n [1/s]; the
/// input's `per_divergence` is rho k_u.
inline double time_scale_source(const SourceInput& in, double density_rate) {
  return in.per_divergence * in.divergence - in.density * density_rate * density_rate * in.deviation;
}

}  // namespace cosurge::fluid
