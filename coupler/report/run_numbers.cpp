#include "coupler/report/run_numbers.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/case/probe_columns.hpp"
#include "coupler/history.hpp"
#include "coupler/summary.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;  // writes numbers that are not finite as null

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool is_clock(const std::string& name) {
  return name == "time" || name.find("/seconds_") != std::string::npos || name.ends_with("/cpu_seconds");
}

bool is_load(const std::string& name) {
  const bool of_solid = name.starts_with("solid/");
  return name.starts_with("coupling/force_") || (of_solid && name.find("/load_") != std::string::npos) ||
         (of_solid && name.find("/contact_load_") != std::string::npos);
}

double integral(const std::vector<double>& time, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double mean = 0.5 * (values[k] + values[k - 1]);
    if (std::isfinite(mean)) sum += mean * (time[k] - time[k - 1]);
  }
  return sum;
}

Json entry(const std::string& name, const std::string& unit, double first, double last) {
  return {{"name", name}, {"unit", unit}, {"first", first}, {"last", last}, {"change", last - first}};
}

}  // namespace

RunRecord::RunRecord(const Results& results) {
  std::size_t rows = std::numeric_limits<std::size_t>::max();
  for (const std::string& name : results.histories()) {
    histories.push_back(results.history(name));
    rows = std::min(rows, histories.back().values.size());
  }
  for (Series& series : histories) series.values.resize(rows);
  summary = summary_of(results, rows);
}

nlohmann::json summary_of(const Results& results, std::size_t windows) {
  auto found = summary_in(results.folder());
  if (found.is_object() && found.value("windows", std::size_t{0}) == windows) return found;
  return nlohmann::json::object();
}

std::string state_of(const nlohmann::json& summary) { return summary.value("status", "unfinished"); }

const Series* RunRecord::find(const std::string& name) const {
  const auto found = std::find_if(histories.begin(), histories.end(),
                                  [&](const Series& series) { return series.name == name; });
  return found == histories.end() ? nullptr : &*found;
}

double RunRecord::last(const std::string& name) const {
  const Series* series = find(name);
  return series == nullptr || series->values.empty() ? unknown : series->values.back();
}

double RunRecord::most(const std::string& name) const {
  const Series* series = find(name);
  double most = unknown;
  if (series != nullptr)
    for (const double value : series->values)
      if (!(value <= most) && !std::isnan(value)) most = value;
  return most;
}

bool of_probe(const std::string& name, const v1::Case& the_case) {
  for (const v1::Probe& probe : the_case.output().probe())
    for (const std::string& column : probe_columns(probe, the_case.dimension()))
      if (name == probe_group(probe) + "/" + column) return true;
  return false;
}

Json extremes(const RunRecord& run, const v1::Case& the_case) {
  Json probes = Json::array(), others = Json::array();
  for (const Series& series : run.histories) {
    if (is_clock(series.name)) continue;
    History history(series.name, series.unit);
    for (std::size_t k = 0; k < run.rows(); ++k) history.add(run.time()[k], series.values[k]);
    Json row = {{"name", series.name},          {"unit", series.unit},
                {"peak", history.peak().value}, {"peak_time", history.peak().time},
                {"min", history.min().value},   {"min_time", history.min().time},
                {"max", history.max().value},   {"max_time", history.max().time},
                {"last", history.last()}};
    (of_probe(series.name, the_case) ? probes : others).push_back(std::move(row));
  }
  probes.insert(probes.end(), others.begin(), others.end());
  return probes;
}

Json impulses(const RunRecord& run, const v1::Case& the_case) {
  Json rows = Json::array();
  for (const Series& series : run.histories) {
    const bool pressure = series.unit == "Pa" && of_probe(series.name, the_case);
    if (pressure || is_load(series.name) || (series.unit == "N" && of_probe(series.name, the_case)))
      rows.push_back({{"name", series.name},
                      {"unit", series.unit + " s"},
                      {"value", integral(run.time(), series.values)}});
  }
  return rows;
}

Json balance(const RunRecord& run) {
  Json rows = Json::array();
  if (run.rows() == 0) return rows;
  for (const std::string member : {"fluid", "solid"}) {
    double first = 0, last = 0;
    int parts = 0;
    for (const std::string kind : {"kinetic_energy", "gravity_energy", "elastic_energy", "contact_energy"}) {
      const Series* series = run.find(fmt::format("{}/{}", member, kind));
      if (series == nullptr) continue;
      rows.push_back(entry(series->name, series->unit, series->values.front(), series->values.back()));
      first += series->values.front();
      last += series->values.back();
      ++parts;
    }
    if (parts > 1) rows.push_back(entry(member + ": sum of energies", "J", first, last));
  }
  for (const std::string name : {"solid/interface_work", "coupling/work_points", "coupling/work_seen",
                                 "coupling/work_created", "solid/contact_work"})
    if (const Series* series = run.find(name))
      rows.push_back(entry(name, series->unit, series->values.front(), series->values.back()));
  return rows;
}

Json phases(const RunRecord& run) {
  Json rows = Json::array();
  for (const Series& series : run.histories) {
    const std::size_t at = series.name.find("/seconds_");
    if (at == std::string::npos || series.values.empty()) continue;
    std::string phase = series.name.substr(at + std::string("/seconds_").size());
    std::replace(phase.begin(), phase.end(), '_', ' ');
    rows.push_back(
        {{"member", series.name.substr(0, at)}, {"phase", phase}, {"seconds", series.values.back()}});
  }
  if (run.summary.contains("exchange_seconds") && run.summary["exchange_seconds"].is_number())
    rows.push_back(
        {{"member", "coupling"}, {"phase", "exchange"}, {"seconds", run.summary["exchange_seconds"]}});
  return rows;
}

Json status(const RunRecord& run, const v1::Case& the_case) {
  return {{"state", state_of(run.summary)},
          {"reason", run.summary.value("reason", "")},
          {"time", run.rows() > 0 ? run.time().back() : 0.0},
          {"end", the_case.time().end()},
          {"windows", run.rows()},
          {"wall_seconds", run.summary.value("wall_seconds", unknown)}};
}

}  // namespace cosurge
