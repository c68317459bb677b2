#include "coupler/converge/spacing_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "common/error.hpp"

namespace cosurge {

SpacingFit::SpacingFit(const std::vector<SpacingSample>& samples) {
  constexpr std::size_t unknowns = 2;
  require(samples.size() > unknowns, "a fit over the spacing needs three runs");
  const auto count = static_cast<double>(samples.size());
  double mean_h = 0, mean_q = 0;
  for (const SpacingSample& s : samples) mean_h += s.spacing / count, mean_q += s.value / count;
  double hh = 0, hq = 0;
  for (const SpacingSample& s : samples) {
    hh += (s.spacing - mean_h) * (s.spacing - mean_h);
    hq += (s.spacing - mean_h) * (s.value - mean_q);
  }
  require(hh > 0, "a fit over the spacing needs runs at two spacings");
  slope_ = hq / hh;
  limit_ = mean_q - slope_ * mean_h;
  double squares = 0;
  for (const SpacingSample& s : samples) squares += std::pow(s.value - value(s.spacing), 2);
  deviation_ = std::sqrt(squares / static_cast<double>(samples.size() - unknowns));
}

double SpacingFit::scatter() const { return deviation_ / std::abs(limit_); }

double SpacingFit::error(double spacing) const {
  return std::hypot(slope_ * spacing, deviation_) / std::abs(limit_);
}

double SpacingFit::spacing_for(double error) const {
  const double room = std::pow(error * limit_, 2) - std::pow(deviation_, 2);
  return room > 0 ? std::sqrt(room) / std::abs(slope_) : 0;
}

CostFit::CostFit(const std::vector<SpacingSample>& samples, int dimension) {
  std::map<double, std::vector<double>> seconds;
  for (const SpacingSample& s : samples) seconds[s.spacing].push_back(s.core_seconds);
  require(seconds.size() > 1, "a fit of the cost needs runs at two spacings");
  const auto mean = [](const std::vector<double>& all) {
    double sum = 0;
    for (const double one : all) sum += one / static_cast<double>(all.size());
    return sum;
  };
  const auto& [finest, at_finest] = *seconds.begin();
  const auto& [next, at_next] = *std::next(seconds.begin());
  finest_ = finest;
  seconds_ = mean(at_finest);
  const double expected = dimension + 1;
  power_ =
      std::clamp(std::log(seconds_ / mean(at_next)) / std::log(next / finest), expected - 1, expected + 1);
}

double CostFit::core_seconds(double spacing) const { return seconds_ * std::pow(finest_ / spacing, power_); }

double CostFit::spacing_for(double core_seconds) const {
  return finest_ * std::pow(seconds_ / core_seconds, 1 / power_);
}

}  // namespace cosurge
