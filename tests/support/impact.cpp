#include "tests/support/impact.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

namespace cosurge {

double Impact::largest() const { return *std::max_element(tip.begin(), tip.end()); }

double Impact::at() const {
  return times[static_cast<std::size_t>(std::max_element(tip.begin(), tip.end()) - tip.begin())];
}

double Impact::mean() const {
  return std::accumulate(tip.begin(), tip.end(), 0.0) / static_cast<double>(tip.size());
}

double Impact::apart(const Impact& another) const {
  double most = 0;
  for (std::size_t k = 0; k < tip.size(); ++k) most = std::max(most, std::abs(tip[k] - another.tip.at(k)));
  return most;
}

Impact impact_on(PlateCase plate, const RecordedPressure& pressure) {
  plate.only_face = true;
  plate.steps_of_period = 40;           // the trapezoidal rule's periods are 0.2 % long then
  const double area = plate.spacing();  // area of a point per metre of width
  Plate run(plate);
  Impact impact;
  const std::vector<double>& times = pressure.times();
  const auto start = std::clock();
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double window = k == 0 ? times[1] - times[0] : times[k] - times[k - 1];
    run.advance(window, [&](const Vec<2>& X) { return Vec<2>(area * pressure.at(k, X[1]), 0); });
    impact.times.push_back(times[k]);
    impact.tip.push_back(run.tip()[0]);
  }
  impact.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return impact;
}

}  // namespace cosurge
