#include "solid_solver/models/modal/modal_model.hpp"

#include "common/state_bytes.hpp"
#include "solid_solver/models/modal/oscillator.hpp"

namespace cosurge::modal {

template <int dim>
ModalModel<dim>::ModalModel(const v1::Solid& solid, double spacing, const Vec<dim>& gravity)
    : bodies_(solid, spacing, gravity) {
  for (const fem::FemBody<dim>& body : bodies_.bodies()) {
    modes_.push_back(lowest_modes(body, bodies_.material(), solid.modal().modes()));
    weight_.emplace_back(modes_.back().shapes.transpose() * body.weight());
    for (Vectors* state : {&position_, &velocity_, &ramp_increment_})
      state->push_back(fem::Vector::Zero(weight_.back().size()));
  }
}

template <int dim>
int ModalModel<dim>::advance(const Window& window, const NodalLoad& load) {
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    const auto& [omega_squared, shapes] = modes_[b];
    const fem::Vector first = shapes.transpose() * bodies_.of_body(b, load.first) + weight_[b];
    const fem::Vector last = shapes.transpose() * bodies_.of_body(b, load.last) + weight_[b];
    for (Eigen::Index i = 0; i < omega_squared.size(); ++i) {
      Oscillator mode{.position = position_[b][i], .velocity = velocity_[b][i]};
      ramp_increment_[b][i] = mode.advance(omega_squared[i], first[i], last[i], window.size);
      position_[b][i] = mode.position;
      velocity_[b][i] = mode.velocity;
    }
  }
  bodies_.check_motion(window, expand(velocity_));
  return 1;
}

template <int dim>
typename ModalModel<dim>::Vectors ModalModel<dim>::expand(const Vectors& amplitudes) const {
  Vectors all;
  for (std::size_t b = 0; b < modes_.size(); ++b) all.emplace_back(modes_[b].shapes * amplitudes[b]);
  return all;
}

template <int dim>
Energies ModalModel<dim>::energies() const {
  Energies sum;
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    sum.kinetic += 0.5 * velocity_[b].squaredNorm();
    sum.elastic += 0.5 * modes_[b].omega_squared.dot(position_[b].cwiseAbs2());
    sum.gravity -= weight_[b].dot(position_[b]);
  }
  return sum;
}

template <int dim>
std::vector<double> ModalModel<dim>::values() const {
  const auto largest = bodies_.deformation(expand(position_));
  return {largest.rotation, largest.strain};
}

template <int dim>
std::string ModalModel<dim>::save() const {
  StateWriter state;
  for (const Vectors* all : {&position_, &velocity_, &ramp_increment_})
    for (const fem::Vector& values : *all) state.put(values);
  return state.take();
}

template <int dim>
void ModalModel<dim>::restore(const std::string& text) {
  StateReader state(text);
  for (Vectors* all : {&position_, &velocity_, &ramp_increment_})
    for (fem::Vector& values : *all) state.get(values);
  state.finish();
}

template class ModalModel<2>;

}  // namespace cosurge::modal
