// Which settings cost least for their error.
#pragma once

#include <vector>

namespace cosurge {

/// One run: what it cost, and how wrong it was.
struct CostAndError {
  double cost;   ///< > 0
  double error;  ///< >= 0; NaN: unknown
};

/// For each run its cost over that of the cheapest run whose error is no larger: 1 on the Pareto front, more
/// elsewhere; NaN where the error is unknown. Of two runs with the same cost and error both are on the front.
std::vector<double> cost_over_front(const std::vector<CostAndError>& runs);

/// Whether each run is on the front: none is as cheap and as accurate, and better in one of the two.
std::vector<bool> on_front(const std::vector<CostAndError>& runs);

}  // namespace cosurge
