// One reported quantity over the windows of a run.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace cosurge {

/// Rows that have not been written yet, and the extremes of all rows for the summary. NaN counts as no value.
class History {
 public:
  struct Extreme {
    double value = std::numeric_limits<double>::quiet_NaN();
    double time = std::numeric_limits<double>::quiet_NaN();  ///< [s] when it was reached first
  };

  /// `name`: "fluid/front", where it lies in the results.
  History(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}

  void add(double time, double value) {
    waiting_.push_back(value);
    last_ = value;
    if (std::isnan(value)) return;
    sum_ += value;
    if (!(value >= min_.value)) min_ = {value, time};
    if (!(value <= max_.value)) max_ = {value, time};
  }

  /// The rows since the last call.
  std::vector<double> take_waiting() { return std::exchange(waiting_, {}); }

  const std::string& name() const { return name_; }
  const std::string& unit() const { return unit_; }
  double last() const { return last_; }
  double sum() const { return sum_; }
  const Extreme& min() const { return min_; }
  const Extreme& max() const { return max_; }

  /// The value farthest from zero.
  const Extreme& peak() const { return std::abs(min_.value) > std::abs(max_.value) ? min_ : max_; }

 private:
  std::string name_;
  std::string unit_;
  std::vector<double> waiting_;
  double last_ = std::numeric_limits<double>::quiet_NaN();
  double sum_ = 0;
  Extreme min_;
  Extreme max_;
};

}  // namespace cosurge
