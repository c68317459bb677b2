#include "solid_solver/carried_model.hpp"

#include <algorithm>

#include "common/state_bytes.hpp"

namespace cosurge {
namespace {

/// Written column by column: GCC 12 warns when a vector from a product is assigned to a column.
template <int dim>
void set_column(Field& all, Eigen::Index n, const Vec<dim>& values) {
  for (int k = 0; k < dim; ++k) all(k, n) = values[k];
}

template <int dim>
Vec<dim> column(const Field& all, Eigen::Index n) {
  Vec<dim> values;
  for (int k = 0; k < dim; ++k) values[k] = all(k, n);
  return values;
}

}  // namespace

template <int dim>
CarriedModel<dim>::CarriedModel(std::unique_ptr<SolidModel> model, const Structure<dim>& structure)
    : WrappedModel(std::move(model)), layout_(model_->layout()), gravity_(structure.gravity) {
  for (const Body<dim>& body : structure.bodies) motion_.push_back(body.carrier);
  ramp_increment_ = Field::Zero(dim, model_->nodes());
}

/// Rotations of the bodies' carriers.
template <int dim>
std::vector<Mat<dim>> CarriedModel<dim>::turned(double t) const {
  std::vector<Mat<dim>> all;
  for (const Motion<dim>& motion : motion_) all.push_back(motion.turned(t));
  return all;
}

template <int dim>
Field CarriedModel<dim>::rotated(const Field& nodal, const std::vector<Mat<dim>>& rotation) const {
  Field all(dim, nodal.cols());
  for (Eigen::Index n = 0; n < nodal.cols(); ++n)
    set_column<dim>(all, n,
                    rotation[static_cast<std::size_t>(layout_.body[static_cast<std::size_t>(n)])] *
                        column<dim>(nodal, n));
  return all;
}

/// Positions in space at time t of points of the carriers' frames [m].
template <int dim>
Field CarriedModel<dim>::carried(const Field& place, double t) const {
  Field all(dim, place.cols());
  for (Eigen::Index n = 0; n < place.cols(); ++n)
    set_column<dim>(all, n, carrier(n).place(column<dim>(place, n), t));
  return all;
}

template <int dim>
Field CarriedModel<dim>::carrier_velocities(const Field& place, double t) const {
  Field all(dim, place.cols());
  for (Eigen::Index n = 0; n < place.cols(); ++n)
    set_column<dim>(all, n, carrier(n).velocity(column<dim>(place, n), t));
  return all;
}

/// Apparent acceleration of nodes at these points of the carriers' frames in the window, in addition to
/// gravity in the initial orientation of the carriers (S46) [m/s2].
template <int dim>
Field CarriedModel<dim>::apparent_acceleration(const Field& place, const Window& window) const {
  const double start = window.start, end = window.start + window.size;
  const Field v = model_->velocity();
  const std::vector<Mat<dim>> middle = turned(0.5 * (start + end)), first = turned(start), last = turned(end);
  Field all = Field::Zero(dim, place.cols());
  for (Eigen::Index n = 0; n < place.cols(); ++n) {
    const auto b = static_cast<std::size_t>(layout_.body[static_cast<std::size_t>(n)]);
    if (!motion_[b].moves()) continue;
    const Vec<dim> X = column<dim>(place, n), v_n = column<dim>(v, n);
    const Vec<dim> carriers = (motion_[b].velocity(X, end) - motion_[b].velocity(X, start)) / window.size;
    const Vec<dim> coriolis = 2 / window.size * ((last[b] - first[b]) * v_n);
    const Vec<dim> seen = gravity_ - carriers - coriolis;
    set_column<dim>(all, n, middle[b].transpose() * seen - gravity_);
  }
  return all;
}

template <int dim>
int CarriedModel<dim>::advance(const Window& window, const NodalLoad& load) {
  const double end = window.start + window.size;
  const Field place = layout_.position + model_->displacement();
  const Field inertia = model_->inertia(apparent_acceleration(place, window));
  const std::vector<Mat<dim>> middle = turned(window.start + 0.5 * window.size);
  std::vector<Mat<dim>> back = middle;
  for (Mat<dim>& R : back) R.transposeInPlace();
  const int taken = model_->advance(
      window, {.first = rotated(load.first, back) + inertia, .last = rotated(load.last, back) + inertia});
  time_ = end;
  ramp_increment_ =
      rotated(model_->ramp_increment(), middle) + 0.5 * (carried(place, end) - carried(place, window.start));
  return taken;
}

template <int dim>
Field CarriedModel<dim>::displacement() const {
  return carried(layout_.position + model_->displacement(), time_) - layout_.position;
}

template <int dim>
Field CarriedModel<dim>::velocity() const {
  return carrier_velocities(layout_.position + model_->displacement(), time_) +
         rotated(model_->velocity(), turned(time_));
}

template <int dim>
Field CarriedModel<dim>::acceleration_by(const Field& load) const {
  const std::vector<Mat<dim>> now = turned(time_);
  std::vector<Mat<dim>> back = now;
  for (Mat<dim>& R : back) R.transposeInPlace();
  return rotated(model_->acceleration_by(rotated(load, back)), now);
}

template <int dim>
Energies CarriedModel<dim>::energies() const {
  const Field carriers = carrier_velocities(layout_.position + model_->displacement(), time_);
  const Field momentum = model_->inertia(carriers);
  const Field weight = model_->inertia(gravity_.replicate(1, nodes()));
  Energies sum = model_->energies();
  sum.kinetic += momentum.cwiseProduct(rotated(model_->velocity(), turned(time_)) + 0.5 * carriers).sum();
  sum.gravity = -weight.cwiseProduct(displacement()).sum();
  return sum;
}

template <int dim>
std::string CarriedModel<dim>::save() const {
  StateWriter state;
  state.put(time_);
  state.put(ramp_increment_);
  state.put(model_->save());
  return state.take();
}

template <int dim>
void CarriedModel<dim>::restore(const std::string& bytes) {
  StateReader state(bytes);
  std::string model;
  state.get(time_);
  state.get(ramp_increment_);
  state.get(model);
  state.finish();
  model_->restore(model);
}

template <int dim>
Snapshot CarriedModel<dim>::frame() const {
  Snapshot arrays = model_->frame();
  const auto array = [&](const std::string& name) {
    return std::find_if(arrays.begin(), arrays.end(), [&](const Array& a) { return a.name == name; });
  };
  const auto position = array("solid_position"), velocity = array("solid_velocity");
  const std::vector<Mat<dim>> now = turned(time_);
  for (std::size_t p = 0; p < layout_.particle_body.size(); ++p) {
    const auto b = static_cast<std::size_t>(layout_.particle_body[p]);
    Vec<dim> X, v;
    for (int k = 0; k < dim; ++k) {
      X[k] = position->values[dim * p + static_cast<std::size_t>(k)];
      v[k] = velocity->values[dim * p + static_cast<std::size_t>(k)];
    }
    const Vec<dim> x = motion_[b].place(X, time_);
    v = motion_[b].velocity(X, time_) + now[b] * v;
    for (int k = 0; k < dim; ++k) {
      position->values[dim * p + static_cast<std::size_t>(k)] = static_cast<float>(x[k]);
      velocity->values[dim * p + static_cast<std::size_t>(k)] = static_cast<float>(v[k]);
    }
  }
  return arrays;
}

template <int dim>
std::unique_ptr<SolidModel> with_carriers(std::unique_ptr<SolidModel> model,
                                          const Structure<dim>& structure) {
  const bool moves = std::any_of(structure.bodies.begin(), structure.bodies.end(),
                                 [](const Body<dim>& body) { return body.carrier.moves(); });
  return moves ? std::make_unique<CarriedModel<dim>>(std::move(model), structure) : std::move(model);
}

template class CarriedModel<2>;
template class CarriedModel<3>;
template std::unique_ptr<SolidModel> with_carriers<2>(std::unique_ptr<SolidModel>, const Structure<2>&);
template std::unique_ptr<SolidModel> with_carriers<3>(std::unique_ptr<SolidModel>, const Structure<3>&);

}  // namespace cosurge
