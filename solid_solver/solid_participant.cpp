#include "solid_solver/solid_participant.hpp"

#include <cassert>
#include <limits>
#include <numbers>

#include "common/error.hpp"
#include "common/solvers.hpp"
#include "common/state_bytes.hpp"
#include "common/version.hpp"
#include "solid_solver/carried_model.hpp"
#include "solid_solver/contact/contact_model.hpp"
#include "solid_solver/from_case.hpp"
#include "solid_solver/models/make_model.hpp"
#include "solid_solver/slowest_oscillation.hpp"

namespace cosurge {
namespace {

/// Longest window [s] that resolves an oscillation of `frequency` [rad/s]: weak coupling reduces the
/// amplitude in proportion to the window (docs/stability.md); without water the structure's own time
/// integration sets the limit. The window is at least half of the water's: an oscillation that is much faster
/// follows the load quasi-statically.
template <int dim>
double window_of(const Surroundings<dim>& surroundings, double frequency, bool loaded) {
  constexpr double shortest = 0.5;  // share of the water's window
  if (frequency == 0) return std::numeric_limits<double>::infinity();
  const double windows_per_period = loaded ? 200 : 50;
  const double resolved = 2 * std::numbers::pi / (windows_per_period * frequency);
  return surroundings.tank ? std::max(resolved, shortest * surroundings.window) : resolved;
}

}  // namespace

Identity SolidParticipant::identity() const {
  return {
      .program = "solid_solver", .version = version, .dimensions = {2, 3}, .capabilities = {"save", "frame"}};
}

Setup SolidParticipant::initialize(const v1::Case& the_case, const Interface& interface,
                                   const InterfaceLoad& load, InterfaceMotion& motion) {
  cpu_seconds_at_start_ = cpu_seconds();
  dimension_ = the_case.dimension();
  Interface points = interface;
  if (points.points() == 0) points.position = Field::Zero(dimension_, 0);
  return dimension_ == 2 ? start(scene_from_case<2>(the_case), points, load, motion)
                         : start(scene_from_case<3>(the_case), points, load, motion);
}

template <int dim>
Setup SolidParticipant::start(const Scene<dim>& scene, const Interface& interface, const InterfaceLoad& load,
                              InterfaceMotion& motion) {
  const Structure<dim>& structure = scene.structure;
  model_ =
      contact::with_contact(with_carriers(make_model(structure), structure), structure, scene.surroundings);
  exchange_ = scene.exchange;
  H_ = model_->interpolation(interface.position, interface.body);
  place_probes(scene.probes);
  if (exchange_.modes > 0) modes_.emplace(structure, interface, *model_, exchange_.modes);

  const Eigen::Index points = interface.points();
  motion = InterfaceMotion::at_rest(dim, points);
  displacement_ = model_->displacement();
  load_ =
      load.force.cols() == points && points > 0 ? Field(load.force * H_) : Field::Zero(dim, model_->nodes());
  motion.displacement = displacement_ * H_.transpose();
  if (points > 0 || scene.limits_windows) frequency_ = slowest_oscillation(structure, *model_);
  if (scene.limits_windows) {
    dry_window_ = window_of(scene.surroundings, frequency_, false);
    wet_window_ = window_of(scene.surroundings, frequency_, true);
  }
  motion.frequency = frequency_;
  return {.columns = columns(),
          .particles = model_->particles(),
          .window = dry_window_,
          .substep = model_->substep()};
}

template <int dim>
void SolidParticipant::place_probes(const std::vector<DisplacementProbe<dim>>& probes) {
  std::vector<int> bodies;
  Field positions(dim, static_cast<Eigen::Index>(probes.size()));
  for (const DisplacementProbe<dim>& probe : probes) {
    positions.col(static_cast<Eigen::Index>(bodies.size())) = probe.position;
    bodies.push_back(probe.body);
    probes_.names.push_back(probe.name);
  }
  probes_.H = model_->interpolation(positions, bodies);
}

/// Responses of the modes to the load of the window that the model has just computed with `motion`.
std::vector<Mode> SolidParticipant::modes(const Window& window, const InterfaceLoad& load,
                                          const InterfaceMotion& motion) const {
  if (!modes_ || window.attempt != Attempt::first) return {};
  const std::size_t order = 1 + (exchange_.end_velocity ? 0 : 1) + (exchange_.ramped ? 1 : 0);
  return modes_->answers(*model_, window, H_, motion.displacement, load.force, order);
}

Report SolidParticipant::advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) {
  assert(load.force.cols() == H_.rows());
  if (window.attempt == Attempt::first) remembered_ = save();
  if (window.attempt == Attempt::again) restore(remembered_);
  clock_.enter(mapping);
  const Field new_load = load.force * H_;
  const NodalLoad nodal_load{.first = exchange_.ramped ? load_ : new_load, .last = new_load};
  clock_.enter(substeps);
  const int taken = model_->advance(window, nodal_load);
  clock_.enter(mapping);
  const Field moved = model_->displacement();
  const Field increment = moved - displacement_;
  // Work sum (first + s (last - first)) . dq with s of (S14).
  const Field late = exchange_.ramped ? model_->ramp_increment() : Field::Zero(dimension_, model_->nodes());
  interface_work_ += nodal_load.first.cwiseProduct(increment).sum() +
                     (nodal_load.last - nodal_load.first).cwiseProduct(late).sum();
  motion.displacement = moved * H_.transpose();
  motion.velocity = exchange_.end_velocity ? model_->velocity() * H_.transpose()
                                           : Field(increment * H_.transpose() / window.size);
  motion.ramp_increment = late * H_.transpose();
  motion.modes = modes(window, load, motion);
  motion.frequency = frequency_;
  displacement_ = moved;
  load_ = new_load;
  clock_.leave();
  return {.values = values(taken),
          .window = new_load.isZero(0) ? dry_window_ : wet_window_,
          .notes = model_->take_notes()};
}

std::vector<Column> SolidParticipant::columns() const {
  std::vector<Column> columns = {{"kinetic_energy", "J"},   {"elastic_energy", "J"},  {"gravity_energy", "J"},
                                 {"interface_work", "J"},   {"substeps", "-"},        {"max_speed", "m/s"},
                                 {"seconds_substeps", "s"}, {"seconds_mapping", "s"}, {"cpu_seconds", "s"}};
  for (const Column& column : model_->columns()) columns.push_back(column);
  for (const std::string& name : probes_.names)
    for (int k = 0; k < dimension_; ++k) columns.push_back({name + "_" + "xyz"[k], "m"});
  return columns;
}

std::vector<double> SolidParticipant::values(int substeps_taken) const {
  const Energies energies = model_->energies();
  std::vector<double> values = {energies.kinetic,
                                energies.elastic,
                                energies.gravity,
                                interface_work_,
                                static_cast<double>(substeps_taken),
                                model_->max_speed(),
                                clock_.seconds()[substeps],
                                clock_.seconds()[mapping],
                                cpu_seconds() - cpu_seconds_at_start_};
  for (const double value : model_->values()) values.push_back(value);
  const Field probed = displacement_ * probes_.H.transpose();
  values.insert(values.end(), probed.data(), probed.data() + probed.size());
  return values;
}

std::string SolidParticipant::save() {
  StateWriter state;
  state.put(displacement_);
  state.put(load_);
  state.put(interface_work_);
  state.put(model_->save());
  return state.take();
}

void SolidParticipant::restore(const std::string& state) {
  StateReader reader(state);
  std::string model;
  reader.get(displacement_);
  reader.get(load_);
  reader.get(interface_work_);
  reader.get(model);
  reader.finish();
  model_->restore(model);
}

Snapshot SolidParticipant::frame() { return model_->frame(); }

std::unique_ptr<Solid> make_solid_solver() { return std::make_unique<SolidParticipant>(); }

}  // namespace cosurge
