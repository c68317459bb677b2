#include "coupler/coupler.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "common/case/window_sizes.hpp"
#include "common/error.hpp"
#include "common/state_bytes.hpp"

namespace cosurge {
namespace {

/// @throws Error if two columns have the same name.
void require_different(const std::vector<Column>& columns, const std::string& solver) {
  std::set<std::string> names;
  for (const Column& column : columns)
    require(names.insert(column.name).second,
            "the {} solver has two columns called {}: if one belongs to a probe, rename the probe", solver,
            column.name);
}

}  // namespace

Coupler::Coupler(const v1::Case& the_case, Participants participants)
    : case_(the_case),
      participants_(participants),
      schedule_(the_case),
      scheme_(make_scheme(the_case.coupling(), participants)),
      account_(the_case.coupling().load() == v1::Coupling::ramped) {
  interface_.dimension = the_case.dimension();
  interface_.position = interface_.area = Field::Zero(the_case.dimension(), 0);
  state_.load = InterfaceLoad::zero(the_case.dimension(), 0);
  largest_ = longest_window(the_case);
  if (Fluid* fluid = participants.fluid; fluid != nullptr)
    take_in("fluid", *fluid, fluid->initialize(case_, interface_, state_.load));
  state_.motion = InterfaceMotion::at_rest(the_case.dimension(), interface_.points());
  if (Solid* solid = participants.solid; solid != nullptr)
    take_in("solid", *solid, solid->initialize(case_, interface_, state_.load, state_.motion));
}

void Coupler::take_in(const std::string& name, const Participant& participant, const Setup& setup) {
  require_different(setup.columns, name);
  members_.push_back({.name = name, .identity = participant.identity(), .setup = setup});
  largest_ = std::min(largest_, setup.window);
}

/// The participants of the case, the fluid first.
std::vector<Participant*> Coupler::all() const {
  std::vector<Participant*> all;
  if (participants_.fluid != nullptr) all.push_back(participants_.fluid);
  if (participants_.solid != nullptr) all.push_back(participants_.solid);
  return all;
}

bool Coupler::run(const Observers& observers, const std::function<bool()>& stop) {
  if (!std::exchange(began_, true)) show_frame(observers);
  settle(observers);
  while (!schedule_.finished()) {
    if (stop()) {
      if (waiting_.empty()) return false;
      InterfaceReader scheme = reader(settled_scheme_);
      scheme_->restore(scheme);
      go_back();
      return false;
    }
    try {
      pass(schedule_.next(largest_));
    } catch (...) {
      tell(observers);
      throw;
    }
    const Effort& effort = scheme_->effort();
    if (effort.again) go_back();
    if (!effort.note.empty()) notes_.push_back(fmt::format("t = {:.6g} s: {}", time(), effort.note));
    if (effort.again) continue;
    if (effort.settled || schedule_.at_frame() || schedule_.finished()) settle(observers);
    if (schedule_.at_frame()) show_frame(observers);
  }
  for (Participant* participant : all()) participant->finalize();
  return true;
}

void Coupler::pass(const Window& window) {
  Reports reports = scheme_->advance(window, state_, account_);
  largest_ = longest_window(case_);
  for (const Report& report : reports) largest_ = std::min(largest_, report.window);
  schedule_.complete(window);
  if (!scheme_->effort().converged) ++unconverged_;
  waiting_.push_back({.window = window, .reports = std::move(reports), .values = values()});
}

/// Settles the waiting windows: later windows cannot go back beyond this state.
void Coupler::settle(const Observers& observers) {
  tell(observers);
  settled_.clear();
  if (!scheme_->may_go_back()) return;
  StateWriter state;
  save_all_but_scheme(state);
  settled_ = state.take();
  StateWriter scheme;
  scheme_->save(scheme);
  settled_scheme_ = scheme.take();
}

void Coupler::go_back() {
  waiting_.clear();
  InterfaceReader state = reader(settled_);
  restore_all_but_scheme(state);
  state.finish();
}

void Coupler::tell(const Observers& observers) {
  for (const Row& row : waiting_)
    for (Observer* observer : observers) observer->window(row.window, row.reports, row.values);
  waiting_.clear();
}

std::vector<Column> Coupler::columns() const {
  std::vector<Column> columns = InterfaceAccount::columns(case_.dimension());
  for (const char* name : {"iterations", "residual", "unconverged", "added_mass_ratio"})
    columns.push_back({name, "-"});
  return columns;
}

std::vector<double> Coupler::values() const {
  std::vector<double> values = account_.values();
  const Effort& effort = scheme_->effort();
  values.insert(values.end(), {static_cast<double>(effort.iterations), effort.residual,
                               static_cast<double>(unconverged_), scheme_->ratio().value()});
  return values;
}

void Coupler::show_frame(const std::vector<Observer*>& observers) {
  std::vector<Snapshot> snapshots;
  for (Participant* participant : all()) snapshots.push_back(participant->frame());
  for (Observer* observer : observers) observer->frame(schedule_.time(), snapshots);
}

std::string Coupler::save() const {
  StateWriter state;
  save_all_but_scheme(state);
  scheme_->save(state);
  return state.take();
}

void Coupler::restore(const std::string& bytes, bool same_scheme) {
  InterfaceReader state = reader(bytes);
  restore_all_but_scheme(state);
  if (same_scheme) {
    scheme_->restore(state);
    state.finish();
  }
  began_ = true;  // the frame at the start was shown before the state was saved
}

void Coupler::save_all_but_scheme(StateWriter& state) const {
  schedule_.save(state);
  account_.save(state);
  state.put(unconverged_);
  state.put(largest_);
  const InterfaceMotion& motion = state_.motion;
  for (const Field* field :
       {&motion.displacement, &motion.velocity, &motion.ramp_increment, &state_.load.force})
    state.put(*field);
  state.put(state_.load.pressure);
  for (Participant* participant : all()) state.put(participant->save());
}

InterfaceReader Coupler::reader(const std::string& state) const {
  return {state, interface_.dimension, interface_.points()};
}

void Coupler::restore_all_but_scheme(InterfaceReader& state) {
  schedule_.restore(state);
  account_.restore(state);
  state.get(unconverged_);
  state.get(largest_);
  require(largest_ > 0, "saved state: the next window is {} s, must be > 0; it is damaged", largest_);
  InterfaceMotion& motion = state_.motion;
  for (Field* field : {&motion.displacement, &motion.velocity, &motion.ramp_increment, &state_.load.force})
    state.get(*field);
  state.get(state_.load.pressure);
  motion.modes.clear();
  for (Participant* participant : all()) {
    std::string saved;
    state.get(saved);
    participant->restore(saved);
  }
}

}  // namespace cosurge
