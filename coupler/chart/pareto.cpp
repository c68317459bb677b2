#include "coupler/chart/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cosurge {

std::vector<double> cost_over_front(const std::vector<CostAndError>& runs) {
  std::vector<double> ratios;
  for (const CostAndError& run : runs) {
    double cheapest = run.cost;
    for (const CostAndError& other : runs)
      if (other.error <= run.error) cheapest = std::min(cheapest, other.cost);
    ratios.push_back(std::isnan(run.error) ? std::numeric_limits<double>::quiet_NaN() : run.cost / cheapest);
  }
  return ratios;
}

std::vector<bool> on_front(const std::vector<CostAndError>& runs) {
  std::vector<bool> front;
  for (const CostAndError& run : runs)
    front.push_back(!std::isnan(run.error) &&
                    std::none_of(runs.begin(), runs.end(), [&](const CostAndError& other) {
                      return other.cost <= run.cost && other.error <= run.error &&
                             (other.cost < run.cost || other.error < run.error);
                    }));
  return front;
}

}  // namespace cosurge
