#include "common/case/lattice_rules.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cosurge {
bool divides(double spacing, double length) {
  const double quotient = length / spacing;
  const double nearest = std::round(quotient);
  return (nearest != 0 || length == 0) &&
         std::abs(quotient - nearest) < whole_spacings * std::max(1.0, std::abs(quotient));
}

namespace {

/// The nearest spacing below (step = +1) or above (-1) the given one that divides every length, searched as
/// fractions of the shortest length.
std::optional<double> nearest_spacing(double spacing, const std::vector<double>& lengths, int step) {
  const double shortest = *std::min_element(lengths.begin(), lengths.end());
  const auto fits = [&](double s) {
    return std::all_of(lengths.begin(), lengths.end(), [&](double length) { return divides(s, length); });
  };
  const int parts =
      static_cast<int>(step > 0 ? std::ceil(shortest / spacing) : std::floor(shortest / spacing));
  constexpr int search = 2000;
  for (int n = parts; n > 0 && n < parts + search; n += step)
    if (fits(shortest / n)) return shortest / n;
  return std::nullopt;
}

}  // namespace

void check_spacing(const std::string& key, double spacing, const std::vector<NamedBox>& boxes,
                   CaseErrors& errors) {
  std::vector<double> lengths;
  std::vector<std::string> wrong, rounded;
  double farthest = 0;
  std::string farthest_key;
  for (const NamedBox& named : boxes) {
    for (int k = 0; k < named.box.min_size(); ++k) {
      for (const double value : {named.box.min(k), named.box.max(k)}) {
        if (value != 0) lengths.push_back(std::abs(value));
        if (std::abs(value) > farthest) {
          farthest = std::abs(value);
          farthest_key = fmt::format("the coordinate {} of {}", value, named.key);
        }
        if (divides(spacing, value)) continue;
        wrong.push_back(fmt::format("{} ({:.6g} is {:.4g} spacings)", named.key, value, value / spacing));
        rounded.push_back(fmt::format("{:.6g} to {:.6g}", value, std::round(value / spacing) * spacing));
      }
    }
  }
  constexpr double finest = 1e5;  // spacings along a side: no memory holds more
  if (farthest > finest * spacing)
    return errors.add(key, fmt::format("{} must be >= {:.6g} [m]: {} is {:.3g} spacings, at most {:.0f} are "
                                       "possible",
                                       spacing, farthest / finest, farthest_key, farthest / spacing, finest));
  if (wrong.empty()) return;
  const auto below = nearest_spacing(spacing, lengths, 1);
  const auto above = nearest_spacing(spacing, lengths, -1);
  errors.add(key,
             fmt::format("{} does not divide {}; the nearest values that divide every box are {} below and "
                         "{} above; or round {}, or give the shape as an outline, which need not fit",
                         spacing, fmt::join(wrong, ", "), below ? fmt::format("{:.6g}", *below) : "none",
                         above ? fmt::format("{:.6g}", *above) : "none", fmt::join(rounded, ", ")));
}

}  // namespace cosurge
