#include "coupler/report/packed_histories.hpp"

#include <cmath>

#include "coupler/report/packing.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t parts = 4096;        // more than a screen has columns
constexpr std::size_t most_exact = 60000;  // rows of probes and loads

bool is_clock(const std::string& name) {
  return name.find("/seconds_") != std::string::npos || name.ends_with("/cpu_seconds");
}

bool is_important(const Series& series, const v1::Case& the_case) {
  return of_probe(series.name, the_case) || series.unit == "N";
}

/// Two rows per part: for the time its quarter and three quarters, for a history its smallest and largest
/// value in their order.
std::vector<double> thinned(const std::vector<double>& values, bool time) {
  std::vector<double> out;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = values.size() * part / parts, last = values.size() * (part + 1) / parts;
    if (time) {
      out.push_back(values[first + (last - first) / 4]);
      out.push_back(values[first + 3 * (last - first) / 4]);
      continue;
    }
    std::size_t least = first, most = first;
    for (std::size_t k = first; k < last; ++k) {
      if (values[k] < values[least] || std::isnan(values[least])) least = k;
      if (values[k] > values[most] || std::isnan(values[most])) most = k;
    }
    out.push_back(values[std::min(least, most)]);
    out.push_back(values[std::max(least, most)]);
  }
  return out;
}

Json table(const std::vector<double>& time, const std::vector<const Series*>& columns, bool exact) {
  const auto kept = [&](const std::vector<double>& values, bool is_time) {
    return exact ? values : thinned(values, is_time);
  };
  Json names = {{{"name", "time"}, {"unit", "s"}}};
  std::vector<std::uint8_t> bytes;
  const std::vector<double> times = kept(time, true);
  append_planes(bytes, std::span<const double>(times));
  for (const Series* series : columns) {
    names.push_back({{"name", series->name}, {"unit", series->unit}});
    const std::vector<double> values = kept(series->values, false);
    const std::vector<float> single(values.begin(), values.end());
    append_planes(bytes, std::span<const float>(single));
  }
  return {{"exact", exact}, {"rows", times.size()}, {"columns", names}, {"data", packed(bytes)}};
}

}  // namespace

Json pack_histories(const RunRecord& run, const v1::Case& the_case, std::size_t first) {
  const auto from = [&](const std::vector<double>& values) {
    return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(std::min(first, values.size())),
                               values.end());
  };
  const std::vector<double> time = from(run.time());
  const bool all_exact = time.size() <= 2 * parts;
  std::vector<Series> kept;
  for (const Series& series : run.histories)
    if (series.name != "time" && !is_clock(series.name))
      kept.push_back({.name = series.name, .unit = series.unit, .values = from(series.values)});
  std::vector<const Series*> exact, thin;
  for (const Series& series : kept) {
    const bool complete = all_exact || (time.size() <= most_exact && is_important(series, the_case));
    (complete ? exact : thin).push_back(&series);
  }
  Json tables = Json::array();
  if (!exact.empty()) tables.push_back(table(time, exact, true));
  if (!thin.empty()) tables.push_back(table(time, thin, false));
  return tables;
}

}  // namespace cosurge
