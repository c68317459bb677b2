// A quantity over time, and what is computed from it.
#pragma once

#include <vector>

namespace cosurge {

/// Values at ascending times; NaN counts as no value.
struct Curve {
  std::vector<double> time;  ///< [s]
  std::vector<double> values;
};

/// A range of time, ends included [s].
struct TimeRange {
  double from;
  double to;
};

/// The curve at `time` [s], linear between its points; NaN outside of them or beside a missing value.
double value_at(const Curve& curve, double time);

/// The points within the range, and the interpolated values at its ends where the curve goes beyond them.
Curve cut(const Curve& curve, const TimeRange& range);

/// Point of the value farthest from zero, the first of them; NaN without any value.
struct Peak {
  double time;
  double value;
};
Peak peak_of(const Curve& curve);

/// Integral over time by the trapezoidal rule; intervals with a missing value are left out.
double integral_of(const Curve& curve);

/// Root mean square over time by the trapezoidal rule; NaN where no interval has both of its values.
double rms_of(const Curve& curve);

/// The first curve less the second, at the times of the first.
Curve difference_of(const Curve& first, const Curve& second);

}  // namespace cosurge
