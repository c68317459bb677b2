// A number of a run: a peak, its time, an impulse, or a whole history.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupler/study/curve.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// One quantity of a run, as in `peak(tip.x)` or `rms(left-right, 0.1..0.4)`:
///   peak(H)          the value of the history H farthest from zero
///   time_of_peak(H)  when it is reached first [s]
///   impulse(H)       integral of H over time
///   rms(H)           root mean square of H less the true history
/// H is a probe's column ("P01"; "tip.x" for a component), a column of the results ("fluid/front",
/// "coupling/force_x"), or the difference of two.
class Quantity {
 public:
  enum class Kind { peak, time_of_peak, impulse, rms };

  /// @throws Error where `text` has another form, or the case writes no such column.
  static Quantity read(const std::string& text, const v1::Case& the_case);

  const std::string& text() const { return text_; }
  Kind kind() const { return kind_; }
  const std::string& history() const { return history_; }               ///< H as it was given
  const std::vector<std::string>& columns() const { return columns_; }  ///< one, or two to subtract
  const std::optional<TimeRange>& range() const { return range_; }      ///< none: the whole run

  /// Unit of the quantity of a history with the unit `unit`.
  std::string unit(const std::string& unit) const;

  /// The quantity of a history. For rms: of the history itself.
  double value(const Curve& history) const;

 private:
  std::string text_;
  Kind kind_ = Kind::peak;
  std::string history_;
  std::vector<std::string> columns_;
  std::optional<TimeRange> range_;
};

}  // namespace cosurge
