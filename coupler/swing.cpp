#include "coupler/swing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cosurge {
namespace {

constexpr double growing = 3;    // ratio to the change in the second quarter; noise alone has 0.5 to 5
constexpr double turning = 0.9;  // share of a load change that the next one reverses; noise has 0.5

double range(const std::vector<double>& values, std::size_t from) {
  if (from >= values.size()) return 0;
  const auto [low, high] =
      std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(from), values.end());
  return *high - *low;
}

}  // namespace

Swing::Swing(const Coupler& coupler) : dimension_(static_cast<std::size_t>(coupler.interface().dimension)) {
  for (std::size_t m = 0; m < coupler.members().size(); ++m) {
    if (coupler.members()[m].name != "solid") continue;
    solid_ = m;
    const std::vector<Column>& columns = coupler.members()[m].setup.columns;
    for (std::size_t c = 0; c < columns.size() && components_.size() < dimension_; ++c)
      if (columns[c].unit == "m" && columns[c].name.ends_with(std::string("_") + "xyz"[components_.size()]))
        components_.push_back(c);
  }
  force_.resize(dimension_);
  displacement_.resize(components_.size());
}

void Swing::window(const Window& window, const Reports& reports, const std::vector<double>& coupling) {
  time_.push_back(window.start + window.size);
  work_.push_back(coupling[0]);
  created_.push_back(coupling[2]);
  for (std::size_t k = 0; k < dimension_; ++k) force_[k].push_back(coupling[3 + k]);
  iterations_.push_back(coupling[3 + dimension_]);
  ratio_.push_back(coupling[6 + dimension_]);
  for (std::size_t k = 0; k < components_.size(); ++k)
    displacement_[k].push_back(reports[solid_].values[components_[k]]);
}

double Swing::iterations() const {
  return std::accumulate(iterations_.begin(), iterations_.end(), 0.0) /
         std::max<double>(1, static_cast<double>(iterations_.size()));
}

double Swing::largest_ratio() const {
  return ratio_.empty() ? 0 : *std::max_element(ratio_.begin(), ratio_.end());
}

double Swing::mean_change(double from, double to) const {
  const auto begin =
      std::max<std::size_t>(1, static_cast<std::size_t>(from * static_cast<double>(windows())));
  const auto end = static_cast<std::size_t>(to * static_cast<double>(windows()));
  double sum = 0;
  for (std::size_t k = begin; k < end; ++k)
    for (const std::vector<double>& force : force_) sum += std::pow(force[k] - force[k - 1], 2);
  return std::sqrt(sum / std::max<double>(1, static_cast<double>(end) - static_cast<double>(begin)));
}

double Swing::alternation() const {
  const double early = mean_change(0.25, 0.5);
  return early > 0 ? mean_change(0.75, 1) / early : 0;
}

double Swing::created() const {
  double passed = 0;
  for (std::size_t k = 1; k < work_.size(); ++k) passed += std::abs(work_[k] - work_[k - 1]);
  return passed > 0 ? created_.back() / passed : 0;
}

bool Swing::alternates() const {
  const std::size_t from = windows() - windows() / 4;
  double change = 0, back = 0, square = 0;
  for (std::size_t k = std::max<std::size_t>(2, from); k < windows(); ++k)
    for (const std::vector<double>& force : force_) {
      const double now = force[k] - force[k - 1];
      change += now * now;
      back -= now * (force[k - 1] - force[k - 2]);
      square += force[k] * force[k];
    }
  return back > turning * change && (change > 0.25 * square || !(alternation() <= growing));
}

const char* Swing::judgement() const {
  if (alternates() || !(created() <= InterfaceAccount::much)) return "growing";
  return created() < -InterfaceAccount::much ? "draining" : "stable";
}

const std::vector<double>& Swing::displacement() const {
  static const std::vector<double> none;
  const std::vector<double>* largest = &none;
  for (const std::vector<double>& one : displacement_)
    if (range(one, 0) > range(*largest, 0)) largest = &one;
  return *largest;
}

double Swing::frequency() const {
  const std::vector<double>& y = displacement();
  const std::size_t half = y.size() / 2;
  if (half < 2) return 0;
  const double mean = std::accumulate(y.begin() + static_cast<std::ptrdiff_t>(half), y.end(), 0.0) /
                      static_cast<double>(y.size() - half);
  std::vector<double> passages;
  for (std::size_t k = 1; k < y.size(); ++k) {
    const double a = y[k - 1] - mean, b = y[k] - mean;
    if (a < 0 && b >= 0) passages.push_back(time_[k - 1] + a / (a - b) * (time_[k] - time_[k - 1]));
  }
  return passages.size() < 2
             ? 0
             : static_cast<double>(passages.size() - 1) / (passages.back() - passages.front());
}

double Swing::peak() const {
  const std::vector<double>& y = displacement();
  return y.empty() ? 0 : *std::max_element(y.begin(), y.end());
}

double Swing::peak_time() const {
  const std::vector<double>& y = displacement();
  return y.empty() ? 0 : time_[static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin())];
}

double Swing::amplitude() const { return range(displacement(), displacement().size() / 2) / 2; }

}  // namespace cosurge
