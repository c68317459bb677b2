// The reference values (truth) of a chart: a run of its plan, a curve, or a number.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupler/study/quantity.hpp"

namespace cosurge {

/// The truth of one quantity: a number, a history, or, if it has neither, that of a run of the plan.
struct Truth {
  std::string name;  ///< "walhorn_2005.csv", "0.047"; empty for a run
  std::optional<double> number;
  std::optional<Curve> curve;
};

/// The parsed arguments of --truth.
struct Truths {
  std::vector<Truth> of_quantity;     ///< truth of each quantity, in their order
  std::vector<std::string> settings;  ///< "key=value" of the true run; empty: the most expensive run

  /// Whether some quantity is compared with a run.
  bool needs_run() const;
};

/// Reads the words of --truth: "finest" (the dearest run, also without any word); "key=value" of the case,
/// which choose a run; "FILE.csv", a curve for every quantity; "QUANTITY=NUMBER" and "QUANTITY=FILE.csv".
/// Tables have two columns, the time [s] and the value in the unit of the results (common/case/table.hpp).
/// `end`: of the case [s].
/// @throws Error with all that is wrong.
Truths read_truths(const std::vector<std::string>& words, const std::vector<Quantity>& quantities,
                   double end);

/// The time range that both curves cover, within that of the quantity.
TimeRange common_range(const Quantity& quantity, const Curve& history, const Curve& truth);

/// Value and true value of a quantity. For rms: the rms of the difference, and that of the true history.
struct Comparison {
  double value;
  double truth;
  double error;  ///< >= 0, in the unit of the value
};

/// Compares a history with the truth; `run` is the history of the true run, for a truth that is a run.
Comparison compare(const Quantity& quantity, const Curve& history, const Truth& truth, const Curve& run);

}  // namespace cosurge
