#include "coupler/progress/progress_meter.hpp"

#include <cmath>
#include <limits>

#include "common/case/probe_columns.hpp"

namespace cosurge {
namespace {

double seconds_between(std::chrono::steady_clock::time_point first,
                       std::chrono::steady_clock::time_point second) {
  return std::chrono::duration<double>(second - first).count();
}

}  // namespace

ProgressMeter::ProgressMeter(const v1::Case& the_case, const std::vector<Member>& members,
                             const std::vector<Column>& columns)
    : end_(the_case.time().end()), columns_(columns), speed_(find(members, "fluid", "max_speed")) {
  for (const v1::Probe& probe : the_case.output().probe()) {
    ProbePlace found{.name = probe.name(), .unit = "", .columns = {}, .places = {}};
    for (const std::string& column : probe_columns(probe, the_case.dimension())) {
      const auto place = find(members, probe_group(probe), column);
      if (!place) continue;  // solvers of other authors need not report it
      found.unit = members[place->member].setup.columns[place->column].unit;
      found.columns.push_back(probe_group(probe) + "/" + column);
      found.places.push_back(*place);
    }
    if (!found.places.empty()) probes_.push_back(found);
  }
}

std::optional<ProgressMeter::Place> ProgressMeter::find(const std::vector<Member>& members,
                                                        const std::string& member,
                                                        const std::string& column) {
  for (std::size_t m = 0; m < members.size(); ++m) {
    const auto& columns = members[m].setup.columns;
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (members[m].name == member && columns[c].name == column) return Place{.member = m, .column = c};
  }
  return std::nullopt;
}

bool ProgressMeter::count(const Window& window, double interval) {
  if (!begin_) begin_ = window.start;
  last_ = window;
  ++unshown_;
  return window.start + window.size >= end_ || seconds_between(shown_, Clock::now()) >= interval;
}

ProgressState ProgressMeter::state(const Reports& reports, const std::vector<double>& coupling) {
  const auto now = Clock::now();
  ProgressState state;
  state.time = last_.start + last_.size;
  state.end = end_;
  state.window = last_.index + 1;
  state.window_size = last_.size;
  state.seconds = seconds_between(start_, now);
  told_ += unshown_;
  // Schemes that may repeat windows report several windows at once; the last state has the mean of the whole
  // run.
  state.seconds_per_window =
      state.time >= end_ ? state.seconds / told_ : seconds_between(shown_, now) / unshown_;
  state.seconds_left = state.seconds * std::max(0.0, end_ - state.time) / (state.time - *begin_);
  unshown_ = 0;
  shown_ = now;
  state.probe = main_probe(reports);
  state.max_speed =
      speed_ ? reports[speed_->member].values[speed_->column] : std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; reports.size() > 1 && k < coupling.size(); ++k) {
    if (columns_[k].name == "iterations") state.iterations = coupling[k];
    if (columns_[k].name == "unconverged") state.unconverged = coupling[k];
    if (columns_[k].name == "added_mass_ratio") state.added_mass_ratio = coupling[k];
  }
  return state;
}

/// Of a vector the length.
std::string ProgressMeter::main_probe(const Reports& reports) const {
  if (probes_.empty()) return "";
  const ProbePlace& probe = probes_.front();
  double square = 0, value = 0;
  for (const Place& place : probe.places) {
    value = reports[place.member].values[place.column];
    square += value * value;
  }
  return probe.name + " " + with_unit(probe.places.size() > 1 ? std::sqrt(square) : value, probe.unit);
}

std::vector<ProbeValue> ProgressMeter::probes(const Reports& reports) const {
  std::vector<ProbeValue> values;
  for (const ProbePlace& probe : probes_)
    for (std::size_t k = 0; k < probe.places.size(); ++k)
      values.push_back({.name = probe.columns[k],
                        .unit = probe.unit,
                        .value = reports[probe.places[k].member].values[probe.places[k].column]});
  return values;
}

}  // namespace cosurge
