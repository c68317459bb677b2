#include "tests/support/recorded_pressure.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "common/error.hpp"

namespace cosurge {

RecordedPressure::RecordedPressure(const std::string& file) {
  std::ifstream in(file);
  require(in.good(), "{}: cannot be read", file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    double first = 0;
    require(static_cast<bool>(fields >> first), "{}: '{}' is no row of numbers", file, line);
    std::vector<double> rest;
    for (double value = 0; fields >> value;) rest.push_back(value);
    if (heights_.empty()) {
      heights_ = rest;
      continue;
    }
    require(rest.size() == heights_.size(), "{}: '{}' is not of {} numbers", file, line, heights_.size() + 1);
    times_.push_back(first);
    pressures_.push_back(rest);
  }
  require(heights_.size() > 1 && times_.size() > 1, "{}: needs two gauges and instants", file);
}

double RecordedPressure::at(std::size_t instant, double height) const {
  const std::vector<double>& p = pressures_.at(instant);
  const auto above = std::upper_bound(heights_.begin() + 1, heights_.end() - 1, height);
  const auto k = static_cast<std::size_t>(above - heights_.begin());
  const double share = (height - heights_[k - 1]) / (heights_[k] - heights_[k - 1]);
  return p[k - 1] + std::clamp(share, 0.0, 1.0) * (p[k] - p[k - 1]);
}

}  // namespace cosurge
