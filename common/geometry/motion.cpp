#include "common/geometry/motion.hpp"

#include <algorithm>
#include <numbers>

namespace cosurge {

using std::numbers::pi;

namespace {

/// The nearest slope to `wanted` with which a cubic stays between its ends on a side where the secant has the
/// slope `secant`: between 0 and three times as steep (Fritsch & Carlson 1980, de Boor & Swartz 1977).
double monotone(double wanted, double secant) {
  return secant > 0 ? std::clamp(wanted, 0.0, 3 * secant) : std::clamp(wanted, 3 * secant, 0.0);
}

/// Slope at a row between intervals of length h, k with secants a, b: slope of the parabola through the three
/// rows, or 0 where the motion turns or rests.
double inner_slope(double h, double k, double a, double b) {
  if (a * b <= 0) return 0;
  return monotone(monotone((k * a + h * b) / (h + k), a), b);
}

/// Slope of the parabola at the outer end of an interval of length h, secant a, next to one of k, b.
double end_slope(double h, double k, double a, double b) {
  return monotone(((2 * h + k) * a - h * b) / (h + k), a);
}

}  // namespace

template <int dim>
Motion<dim>::Motion(const Oscillation<dim>& oscillation, const Vec<dim>& pivot)
    : pivot_(pivot), formula_(oscillation) {
  if (formula_.amplitude.isZero()) formula_.frequency = 0;
}

template <int dim>
Motion<dim>::Motion(PoseTable<dim> table, const Vec<dim>& pivot) : pivot_(pivot), table_(std::move(table)) {
  if (table_.row.size() > 1) slope_ = slopes();
}

template <int dim>
auto Motion<dim>::pose(double t) const -> Pose {
  if (!uniform_.isZero()) {
    Pose way = Pose::Zero();
    way.template head<dim>() = t * uniform_;
    return way;
  }
  if (!table_.row.empty()) return from_table(t) - from_table(0);
  const double grown = t < formula_.ramp ? 0.5 * (1 - std::cos(pi * t / formula_.ramp)) : 1;
  const double start = formula_.ramp > 0 ? 0 : std::sin(formula_.phase);
  return (grown * std::sin(2 * pi * formula_.frequency * t + formula_.phase) - start) * formula_.amplitude;
}

template <int dim>
auto Motion<dim>::from_table(double t) const -> Pose {
  const auto& [time, row] = table_;
  if (t <= time.front()) return row.front();
  if (t >= time.back()) return row.back();
  const auto k = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin()) - 1;
  const double h = time[k + 1] - time[k];
  const double s = (t - time[k]) / h;
  const double s2 = s * s;
  const double s3 = s2 * s;
  return row[k] + (3 * s2 - 2 * s3) * (row[k + 1] - row[k]) + (s3 - 2 * s2 + s) * h * slope_[k] +
         (s3 - s2) * h * slope_[k + 1];
}

template <int dim>
auto Motion<dim>::slopes() const -> std::vector<Pose> {
  const auto& [time, row] = table_;
  const std::size_t last = row.size() - 1;
  std::vector<double> h(last);
  std::vector<Pose> secant(last), slope(row.size());
  for (std::size_t k = 0; k < last; ++k) {
    h[k] = time[k + 1] - time[k];
    secant[k] = (row[k + 1] - row[k]) / h[k];
  }
  slope.front() = secant.front();
  slope.back() = secant.back();
  for (int c = 0; c <= dim && last > 1; ++c) {
    slope.front()[c] = end_slope(h[0], h[1], secant[0][c], secant[1][c]);
    slope.back()[c] = end_slope(h[last - 1], h[last - 2], secant[last - 1][c], secant[last - 2][c]);
    for (std::size_t k = 1; k < last; ++k)
      slope[k][c] = inner_slope(h[k - 1], h[k], secant[k - 1][c], secant[k][c]);
  }
  return slope;
}

/// In the plane of the first and the last coordinate, from the first to the last.
template <int dim>
Mat<dim> Motion<dim>::rotation(double angle) const {
  Mat<dim> R = Mat<dim>::Identity();
  R(0, 0) = R(dim - 1, dim - 1) = std::cos(angle);
  R(dim - 1, 0) = std::sin(angle);
  R(0, dim - 1) = -R(dim - 1, 0);
  return R;
}

template <int dim>
Vec<dim> Motion<dim>::place(const Vec<dim>& X, double t) const {
  const Pose now = pose(t);
  return pivot_ + now.template head<dim>() + rotation(now[dim]) * (X - pivot_);
}

template <int dim>
Vec<dim> Motion<dim>::origin(const Vec<dim>& x, double t) const {
  const Pose now = pose(t);
  return pivot_ + rotation(now[dim]).transpose() * (x - pivot_ - now.template head<dim>());
}

template <int dim>
Vec<dim> Motion<dim>::velocity(const Vec<dim>& X, double t) const {
  if (!moves()) return Vec<dim>::Zero();
  constexpr double dt = 1e-6;  // s: far below any motion's time, far above rounding
  if (t < dt) return (place(X, t + dt) - place(X, t)) / dt;  // a formula is not defined before t = 0
  return (place(X, t + dt) - place(X, t - dt)) / (2 * dt);
}

template <int dim>
std::vector<double> Motion<dim>::samples() const {
  if (!table_.row.empty()) return table_.time;
  std::vector<double> times = {0};
  if (!moves()) return times;
  constexpr int a_period = 64;
  const int count = a_period * static_cast<int>(std::ceil(1 + formula_.ramp * formula_.frequency));
  for (int k = 1; k <= count; ++k) times.push_back(k / (a_period * formula_.frequency));
  return times;
}

template <int dim>
Box<dim> Motion<dim>::sweep(const Box<dim>& box) const {
  Box<dim> swept = box;
  for (const double t : samples()) {
    for (int corner = 0; corner < (1 << dim); ++corner) {
      Vec<dim> X;
      for (int k = 0; k < dim; ++k) X[k] = ((corner >> k) & 1) != 0 ? box.max[k] : box.min[k];
      const Vec<dim> x = place(X, t);
      swept.min = swept.min.cwiseMin(x);
      swept.max = swept.max.cwiseMax(x);
    }
  }
  return swept;
}

template class Motion<2>;
template class Motion<3>;

}  // namespace cosurge
