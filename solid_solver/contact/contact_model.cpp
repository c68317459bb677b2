#include "solid_solver/contact/contact_model.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "solid_solver/contact/vertex_motion.hpp"

namespace cosurge::contact {
namespace {

// omega dt of the fastest motion that contact springs cause: 12 sub-steps per oscillation; explicit steps are
// stable up to 2.
constexpr double resolved = 0.5;
// Sub-step of explicit models with contact, as a share of the stable one: (omega dt)^2 is then at most
// 2^2 0.9^2 + 0.5^2 < 2^2.
constexpr double beside_springs = 0.9;
constexpr double fall = 0.03;          // [spacings] longest way at the fall speed in a sub-step
constexpr double windows_share = 0.1;  // longest sub-step, as a share of the longest window
constexpr double foresight = 3;        // search distance [way in a window at the last velocity]
constexpr double rounding = 1e-9;      // smallest depth of a contact [reach]
constexpr double deepest = 0.5;        // largest depth of a contact [reach]; deeper, the facets are not found
constexpr double whole = 1e-6;         // [sub-steps] tolerance: a window of 20.0000001 sub-steps has 20

/// Speed of a fall through the height of the tank, or of all bodies if there is no tank [m/s].
template <int dim>
double fall_speed(const Vec<dim>& gravity, const Surroundings<dim>& surroundings, const Field& vertices) {
  double height = (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).maxCoeff();
  if (surroundings.tank) height = surroundings.tank->box.max[dim - 1] - surroundings.tank->box.min[dim - 1];
  return std::sqrt(2 * gravity.norm() * height);
}

}  // namespace

template <int dim>
ContactModel<dim>::ContactModel(std::unique_ptr<SolidModel> model, const Structure<dim>& structure,
                                const Surroundings<dim>& surroundings)
    : WrappedModel(std::move(model)), neighborhood_(structure, surroundings) {
  H_ = vertex_interpolation(*model_, structure, neighborhood_.vertices(), neighborhood_.body());
  neighborhood_.hold(empty_rows(H_));
  for (const Body<dim>& body : structure.bodies) carrier_.push_back(body.carrier);
  step_ = windows_share * surroundings.window;
  if (const double speed = fall_speed(structure.gravity, surroundings, neighborhood_.vertices()); speed > 0)
    step_ = std::min(step_, fall * structure.spacing / speed);
  if (model_->substep() > 0) step_ = std::min(step_, beside_springs * model_->substep());
  ramp_increment_ = Field::Zero(dim, model_->nodes());
}

/// Positions of all vertices at the end of the last window, t [s]; held vertices move with their carrier.
template <int dim>
Field ContactModel<dim>::positions(double t) const {
  Field x = neighborhood_.vertices() + model_->displacement() * H_.transpose();
  each_carried([&](Eigen::Index v, const Motion<dim>& motion, const Vec<dim>& X) {
    const Vec<dim> now = motion.place(X, t);
    for (int k = 0; k < dim; ++k) x(k, v) = now[k];
  });
  return x;
}

template <int dim>
Field ContactModel<dim>::velocities(double t) const {
  Field u = model_->velocity() * H_.transpose();
  each_carried([&](Eigen::Index v, const Motion<dim>& motion, const Vec<dim>& X) {
    const Vec<dim> now = motion.velocity(X, t);
    for (int k = 0; k < dim; ++k) u(k, v) = now[k];
  });
  return u;
}

/// Calls visit(v, motion, X) for the held vertices whose carrier moves.
template <int dim>
template <typename Visit>
void ContactModel<dim>::each_carried(const Visit& visit) const {
  for (std::size_t v = 0; v < neighborhood_.body().size(); ++v) {
    const auto vertex = static_cast<Eigen::Index>(v);
    const Motion<dim>& motion = carrier_[static_cast<std::size_t>(neighborhood_.body()[v])];
    if (neighborhood_.held(vertex) && motion.moves())
      visit(vertex, motion, Vec<dim>(neighborhood_.vertices().col(vertex)));
  }
}

template <int dim>
bool ContactModel<dim>::may_touch(const Window& window) const {
  const Touches near = neighborhood_.within_reach(positions(window.start), window.start);
  if (near.empty()) return false;
  const Field v = velocities(window.start);
  return std::any_of(near.begin(), near.end(), [&](const Touch<dim>& touch) {
    const double approach = std::max(0.0, -rate(touch, v));
    return touch.gap < foresight * approach * window.size - rounding * neighborhood_.reach();
  });
}

template <int dim>
int ContactModel<dim>::advance(const Window& window, const NodalLoad& load) {
  load_.setZero();
  touching_ = may_touch(window);
  if (!touching_) {
    energy_ = pressed_ = 0;
    return model_->advance(window, load);
  }
  if (stiffness_.empty()) find_stiffness();
  ramp_increment_.setZero();
  const int steps = std::max(1, static_cast<int>(std::ceil(window.size / step_ - whole)));
  const double dt = window.size / steps;
  int taken = 0;
  for (int k = 0; k < steps; ++k) {
    const Window part{.index = window.index, .start = window.start + k * dt, .size = dt};
    taken += step(part, load, static_cast<double>(k) / steps, 1.0 / steps);
  }
  const Touches touches = pressed(positions(window.start + window.size), window.start + window.size);
  pressed_ = static_cast<double>(touches.size());
  energy_ = 0;
  for (const Touch<dim>& touch : touches) energy_ += 0.5 * stiffness(touch) * touch.gap * touch.gap;
  return taken;
}

/// Computes a sub-step that begins after the share `before` of the window and takes `share` of it. The
/// contact forces are those at the instant at which they conserve the energy of the springs (S45).
template <int dim>
int ContactModel<dim>::step(const Window& part, const NodalLoad& load, double before, double share) {
  const double instant = model_->force_instant(), ahead = instant * part.size;
  const Field nodal_v = model_->velocity(), v = velocities(part.start);
  const Touches touches = pressed(positions(part.start) + ahead * v, part.start + ahead);
  note(touches, v, part.start);
  check_depth(touches, part.start);
  const Field force = forces(touches) * H_;
  load_ += share * from_outside(touches);
  const auto at = [&](double s) { return Field(load.first + s * (load.last - load.first) + force); };
  const Field start = model_->displacement();
  const int taken = model_->advance(part, {.first = at(before), .last = at(before + share)});
  const Field moved = model_->displacement() - start;
  // The force acts at its instant: half of it over the way before this instant, half over the way after it.
  const Field way = moved + (0.5 - instant) * (part.size * nodal_v - moved);
  work_ += force.cwiseProduct(way).sum();
  ramp_increment_ += before * moved + share * model_->ramp_increment();
  return taken;
}

template <int dim>
typename ContactModel<dim>::Touches ContactModel<dim>::pressed(const Field& x, double t) const {
  Touches touches = neighborhood_.within_reach(x, t);
  std::erase_if(touches,
                [&](const Touch<dim>& touch) { return touch.gap >= -rounding * neighborhood_.reach(); });
  return touches;
}

template <int dim>
void ContactModel<dim>::find_stiffness() {
  stiffness_ = fastest_per_stiffness(*model_, H_, neighborhood_.area(), neighborhood_.body(),
                                     neighborhood_.bodies(), dim);
  for (double& s : stiffness_) s = s > 0 ? resolved * resolved / (step_ * step_ * s) : 0;
}

template <int dim>
double ContactModel<dim>::stiffness(const Touch<dim>& touch) const {
  double softer = stiffness_[touch.body];
  if (const int other = neighborhood_.body_of(touch.other); other >= 0)
    softer = std::min(softer, stiffness_[other]);
  return softer * touch.share * touch.area;
}

template <int dim>
Field ContactModel<dim>::forces(const Touches& touches) const {
  Field sum = Field::Zero(dim, H_.rows());
  for (const Touch<dim>& touch : touches)
    for (std::size_t k = 0; k < touch.vertex.size(); ++k)
      if (touch.vertex[k] >= 0)
        sum.col(touch.vertex[k]) -= stiffness(touch) * touch.gap * touch.weight[k] * touch.normal;
  return sum;
}

template <int dim>
Vec<dim> ContactModel<dim>::from_outside(const Touches& touches) const {
  Vec<dim> sum = Vec<dim>::Zero();
  for (const Touch<dim>& touch : touches) {
    if (neighborhood_.body_of(touch.other) >= 0) continue;
    double weight = 0;
    for (std::size_t k = 0; k < touch.vertex.size(); ++k)
      if (touch.vertex[k] >= 0) weight += touch.weight[k];
    sum -= stiffness(touch) * touch.gap * weight * touch.normal;
  }
  return sum;
}

template <int dim>
void ContactModel<dim>::note(const Touches& touches, const Field& v, double t) {
  for (const Touch<dim>& touch : touches) {
    const std::array<int, 2> pair = {touch.body, touch.other};
    if (std::find(met_.begin(), met_.end(), pair) != met_.end()) continue;
    met_.push_back(pair);
    notes_.push_back(fmt::format("t = {:.6g} s: solid.body.{} touches {}, near ({:.4g}) m, at {:.3g} m/s", t,
                                 touch.body, neighborhood_.name(touch.other),
                                 fmt::join(touch.place.begin(), touch.place.end(), ", "),
                                 std::max(0.0, -rate(touch, v))));
  }
}

template <int dim>
void ContactModel<dim>::check_depth(const Touches& touches, double t) const {
  const double most = deepest * neighborhood_.reach();
  for (const Touch<dim>& touch : touches)
    if (-touch.gap > most)
      throw NumericalError(
          fmt::format("solid: solid.body.{} is pressed {:.3g} m into {} at t = {:.6g} s, near ({:.4g}) m; "
                      "the limit of the contact springs is {:.3g} m. The load or the speed of the body is "
                      "too large: lower time.window, which makes the springs stiffer",
                      touch.body, -touch.gap, neighborhood_.name(touch.other), t,
                      fmt::join(touch.place.begin(), touch.place.end(), ", "), most));
}

template <int dim>
std::vector<Column> ContactModel<dim>::columns() const {
  std::vector<Column> columns = model_->columns();
  columns.insert(columns.end(), {{"contact_energy", "J"}, {"contact_work", "J"}, {"contact_points", "-"}});
  for (int k = 0; k < dim; ++k) columns.push_back({std::string("contact_load_") + "xyz"[k], "N"});
  return columns;
}

template <int dim>
std::vector<double> ContactModel<dim>::values() const {
  std::vector<double> values = model_->values();
  values.insert(values.end(), {energy_, work_, pressed_});
  values.insert(values.end(), load_.begin(), load_.end());
  return values;
}

template <int dim>
std::vector<std::string> ContactModel<dim>::take_notes() {
  std::vector<std::string> notes = model_->take_notes();
  notes.insert(notes.end(), notes_.begin(), notes_.end());
  notes_.clear();
  return notes;
}

template <int dim>
std::string ContactModel<dim>::save() const {
  StateWriter state;
  state.put(model_->save());
  state.put(met_);
  for (const double value : {energy_, work_, pressed_}) state.put(value);
  state.put(load_);
  state.put(touching_);
  state.put(ramp_increment_);
  return state.take();
}

template <int dim>
void ContactModel<dim>::restore(const std::string& bytes) {
  StateReader state(bytes);
  std::string model;
  state.get(model);
  state.get(met_);
  for (double* value : {&energy_, &work_, &pressed_}) state.get(*value);
  state.get(load_);
  state.get(touching_);
  state.get(ramp_increment_);
  state.finish();
  model_->restore(model);
  notes_.clear();
}

template <int dim>
std::unique_ptr<SolidModel> with_contact(std::unique_ptr<SolidModel> model, const Structure<dim>& structure,
                                         const Surroundings<dim>& surroundings) {
  const bool alone = !surroundings.tank && surroundings.obstacles.empty() && structure.bodies.size() == 1;
  if (alone || structure.template is<RigidParameters>()) return model;
  return std::make_unique<ContactModel<dim>>(std::move(model), structure, surroundings);
}

template std::unique_ptr<SolidModel> with_contact<2>(std::unique_ptr<SolidModel>, const Structure<2>&,
                                                     const Surroundings<2>&);
template std::unique_ptr<SolidModel> with_contact<3>(std::unique_ptr<SolidModel>, const Structure<3>&,
                                                     const Surroundings<3>&);

}  // namespace cosurge::contact
