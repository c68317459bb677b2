#include "fluid_solver/added_mass.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "common/error.hpp"

namespace cosurge::fluid {
namespace {

// Relative residual. With 1e-2 the frequency of a piston in heavy water was 6 % wrong; with 1e-3 the added
// mass is wrong by 1e-5.
constexpr double mode_tolerance = 1e-3;
constexpr int most_iterations = 500;

// Each mode's pressure is solved for once in this many windows; in the others the last solution is used.
constexpr int refresh_interval = 4;

constexpr int most_newton_steps = 30;

// Largest relative change of the accelerations in an iterated window; a tenth of the coupling's default
// tolerance.
constexpr double consistent = 1e-4;
constexpr int most_answers = 5;

}  // namespace

Eigen::VectorXd consistent_accelerations(const ModalLoad& load) {
  const Eigen::Index modes = load.mobility.size();
  Eigen::VectorXd c = Eigen::VectorXd::Zero(modes);
  for (int k = 0; k < most_newton_steps; ++k) {
    const Eigen::VectorXd p = load.pressure + load.per_acceleration * c;
    const Eigen::VectorXd pushing = (p.array() > load.lowest_pressure).cast<double>();
    const Eigen::VectorXd on_modes = load.on_modes * p.cwiseMax(load.lowest_pressure);
    const Eigen::VectorXd residual = c - load.mobility.cwiseProduct(on_modes - load.predicted);
    const Eigen::MatrixXd J =
        Eigen::MatrixXd::Identity(modes, modes) -
        load.mobility.asDiagonal() * load.on_modes * pushing.asDiagonal() * load.per_acceleration;
    const Eigen::VectorXd step = J.partialPivLu().solve(residual);
    c -= step;
    if (step.norm() <= 1e-12 * c.norm()) break;  // exact once the same points have p > lowest in two steps
  }
  return c;
}

/// Right-hand side of the pressure equation for the body acceleration `shape`, one vector per point.
template <int dim>
std::vector<double> AddedMass<dim>::right_hand_side(const Step& step, const Field& shape) const {
  const std::vector<double> divergence = body_divergence(step.bodies, shape);
  const std::vector<std::int32_t>& unknowns = step.bodies.poisson.unknowns();
  std::vector<double> source(step.bodies.particles.u.size(), 0.0);
  for (std::size_t m = 0; m < unknowns.size(); ++m) {
    const auto i = static_cast<std::size_t>(unknowns[m]);
    source[i] = std::max(step.source_per_divergence[i], step.least_per_change) * step.dt * divergence[m];
  }
  return step.bodies.poisson.rows_of(source);
}

template <int dim>
std::vector<double> AddedMass<dim>::last_pressure(const Step& step, std::size_t mode) const {
  const std::vector<std::int32_t>& unknowns = step.bodies.poisson.unknowns();
  std::vector<double> p(unknowns.size());
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    p[k] = last_[mode][static_cast<std::size_t>(step.bodies.particles.id[unknowns[k]])];
  return p;
}

template <int dim>
std::vector<double> AddedMass<dim>::mode_pressure(const Step& step, std::size_t mode) {
  std::vector<double> p = last_pressure(step, mode);
  const bool due = windows_ == 0 || static_cast<int>(mode) % refresh_interval == windows_ % refresh_interval;
  if (!due || step.attempt == Attempt::again) return p;
  solve(step, right_hand_side(step, modes_[mode].shape), mode_tolerance, p);
  const std::vector<std::int32_t>& unknowns = step.bodies.poisson.unknowns();
  std::vector<double>& last = last_[mode];
  std::fill(last.begin(), last.end(), 0.0);
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    last[static_cast<std::size_t>(step.bodies.particles.id[unknowns[k]])] = p[k];
  return p;
}

template <int dim>
void AddedMass<dim>::solve(const Step& step, const std::vector<double>& right_hand_side, double tolerance,
                           std::vector<double>& p) {
  const SolveReport report = conjugate_gradient(step.bodies.poisson.matrix(), right_hand_side,
                                                step.preconditioner, tolerance, most_iterations, p);
  if (!report.converged)
    throw NumericalError(
        fmt::format("pressure of the structure's modes: residual {:.2e} > {:.2e} after {} iterations",
                    report.relative_residual, tolerance, report.iterations));
  iterations_ += report.iterations;
}

/// Acceleration of the body points by the modes' accelerations c [m/s2], dimension x points.
template <int dim>
Field AddedMass<dim>::motion_of(const Step& step, const Eigen::VectorXd& c) const {
  Field motion = Field::Zero(dim, static_cast<Eigen::Index>(step.bodies.body_place.size()));
  for (std::size_t m = 0; m < modes_.size(); ++m) motion += c[static_cast<Eigen::Index>(m)] * modes_[m].shape;
  return motion;
}

/// Solves again for the motion of the modes with the accelerations c, so that the pressure fits this motion
/// even where the pressure of a single mode is old.
template <int dim>
void AddedMass<dim>::answer(const Step& step, const Eigen::VectorXd& c, std::vector<double>& pressure) {
  std::vector<double> rows = right_hand_side(step, motion_of(step, c));
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] += step.bodies.poisson.right_hand_side()[k];
  solve(step, rows, step.tolerance, pressure);
}

template <int dim>
auto AddedMass<dim>::wet_points(const Step& step) const -> std::vector<WetPoint> {
  const std::vector<std::int32_t>& unknowns = step.bodies.poisson.unknowns();
  std::vector<std::int32_t> unknown_at(step.bodies.particles.u.size(), -1);
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    unknown_at[static_cast<std::size_t>(unknowns[k])] = static_cast<std::int32_t>(k);
  std::vector<WetPoint> points;
  for (std::size_t k = 0; k < step.bodies.body_place.size(); ++k) {
    const auto place = static_cast<std::size_t>(step.bodies.body_place[k]);
    if (unknown_at[place] >= 0 && step.bodies.particles.kind[place] == Kind::body_surface)
      points.push_back({.point = k, .unknown = static_cast<std::size_t>(unknown_at[place])});
  }
  return points;
}

template <int dim>
ModalLoad AddedMass<dim>::modal_load(const Step& step, const std::vector<WetPoint>& points,
                                     const std::vector<std::vector<double>>& mode_pressures) const {
  const auto r = static_cast<Eigen::Index>(modes_.size());
  const auto n = static_cast<Eigen::Index>(points.size());
  ModalLoad load{.pressure = {},
                 .per_acceleration = Eigen::MatrixXd(n, r),
                 .on_modes = Eigen::MatrixXd(r, n),
                 .mobility = Eigen::VectorXd(r),
                 .predicted = Eigen::VectorXd(r),
                 .lowest_pressure = step.lowest_pressure};
  for (Eigen::Index m = 0; m < r; ++m) {
    const Mode& mode = modes_[static_cast<std::size_t>(m)];
    load.mobility[m] = mode.mobility / step.dt;
    load.predicted[m] = mode.load;
    for (std::size_t k = 0; k < step.face_load.size(); ++k)
      load.predicted[m] -= step.face_load[k].dot(mode.shape.col(static_cast<Eigen::Index>(k)));
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto [point, u] = points[static_cast<std::size_t>(i)];
      const Vec<dim> phi = mode.shape.col(static_cast<Eigen::Index>(point));
      load.per_acceleration(i, m) = mode_pressures[static_cast<std::size_t>(m)][u];
      load.on_modes(m, i) = -step.body_areas[point].dot(phi);
    }
  }
  return load;
}

template <int dim>
void AddedMass<dim>::couple(const Step& step, std::vector<double>& pressure) {
  ratio_ = 0;
  iterations_ = 0;
  velocity_change_.resize(0, 0);
  if (modes_.empty() || step.source_per_divergence.empty() || pressure.empty()) return;
  const auto ids = static_cast<std::size_t>(
      1 + *std::max_element(step.bodies.particles.id.begin(), step.bodies.particles.id.end()));
  last_.resize(modes_.size());
  for (auto& last : last_) last.resize(std::max(last.size(), ids));

  const std::vector<WetPoint> points = wet_points(step);
  if (points.empty()) return;

  std::vector<std::vector<double>> mode_pressures;
  for (std::size_t m = 0; m < modes_.size(); ++m) mode_pressures.push_back(mode_pressure(step, m));
  ModalLoad load = modal_load(step, points, mode_pressures);
  ratio_ = std::max(
      0.0, -load.mobility.cwiseProduct((load.on_modes * load.per_acceleration).diagonal()).minCoeff());

  Eigen::VectorXd c = Eigen::VectorXd::Zero(load.mobility.size());
  for (int k = 0; k < (step.attempt != Attempt::once ? most_answers : 1); ++k) {
    load.pressure = -load.per_acceleration * c;  // `pressure` already includes the motion with c
    for (std::size_t i = 0; i < points.size(); ++i)
      load.pressure[static_cast<Eigen::Index>(i)] += pressure[points[i].unknown];
    const Eigen::VectorXd next = consistent_accelerations(load);
    if (k > 0 && (next - c).norm() <= consistent * next.norm()) break;
    for (std::size_t m = 0; m < modes_.size(); ++m) {
      const double change = (next - c)[static_cast<Eigen::Index>(m)];
      for (std::size_t u = 0; u < pressure.size(); ++u) pressure[u] += change * mode_pressures[m][u];
    }
    c = next;
    answer(step, c, pressure);
  }
  velocity_change_ = step.dt * motion_of(step, c);
  if (step.attempt != Attempt::again) ++windows_;
}

template <int dim>
void AddedMass<dim>::save(StateWriter& state) const {
  state.put(static_cast<std::uint64_t>(last_.size()));
  for (const auto& last : last_) state.put(last);
  state.put(windows_);
}

template <int dim>
void AddedMass<dim>::restore(StateReader& state) {
  std::uint64_t modes = 0;
  state.get(modes);
  last_.resize(modes);
  for (auto& last : last_) state.get(last);
  state.get(windows_);
}

template class AddedMass<2>;
template class AddedMass<3>;

}  // namespace cosurge::fluid
