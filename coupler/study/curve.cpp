#include "coupler/study/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cosurge {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double value_at(const Curve& curve, double time) {
  const auto next = std::lower_bound(curve.time.begin(), curve.time.end(), time);
  if (next == curve.time.end()) return unknown;
  const auto k = static_cast<std::size_t>(next - curve.time.begin());
  if (*next == time) return curve.values[k];
  if (k == 0) return unknown;
  const double share = (time - curve.time[k - 1]) / (curve.time[k] - curve.time[k - 1]);
  return (1 - share) * curve.values[k - 1] + share * curve.values[k];
}

Curve cut(const Curve& curve, const TimeRange& range) {
  Curve part;
  const auto add = [&](double time, double value) {
    part.time.push_back(time);
    part.values.push_back(value);
  };
  const auto add_end = [&](double time) {
    const double value = value_at(curve, time);
    if (!std::isnan(value) && (part.time.empty() || part.time.back() < time)) add(time, value);
  };
  add_end(range.from);
  for (std::size_t k = 0; k < curve.time.size(); ++k)
    if (curve.time[k] >= range.from && curve.time[k] <= range.to &&
        (part.time.empty() || part.time.back() < curve.time[k]))
      add(curve.time[k], curve.values[k]);
  add_end(range.to);
  return part;
}

Peak peak_of(const Curve& curve) {
  Peak peak{.time = unknown, .value = unknown};
  for (std::size_t k = 0; k < curve.time.size(); ++k)
    if (!std::isnan(curve.values[k]) && !(std::abs(curve.values[k]) <= std::abs(peak.value)))
      peak = {.time = curve.time[k], .value = curve.values[k]};
  return peak;
}

double integral_of(const Curve& curve) {
  double sum = 0;
  for (std::size_t k = 1; k < curve.time.size(); ++k) {
    const double mean = 0.5 * (curve.values[k] + curve.values[k - 1]);
    if (!std::isnan(mean)) sum += mean * (curve.time[k] - curve.time[k - 1]);
  }
  return sum;
}

double rms_of(const Curve& curve) {
  double sum = 0, length = 0;
  for (std::size_t k = 1; k < curve.time.size(); ++k) {
    const double square =
        0.5 * (curve.values[k] * curve.values[k] + curve.values[k - 1] * curve.values[k - 1]);
    if (std::isnan(square)) continue;
    sum += square * (curve.time[k] - curve.time[k - 1]);
    length += curve.time[k] - curve.time[k - 1];
  }
  return length > 0 ? std::sqrt(sum / length) : unknown;
}

Curve difference_of(const Curve& first, const Curve& second) {
  Curve difference = first;
  for (std::size_t k = 0; k < first.time.size(); ++k) difference.values[k] -= value_at(second, first.time[k]);
  return difference;
}

}  // namespace cosurge
