#include "solid_solver/models/modal/modal_model.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "solid_solver/damping.hpp"
#include "solid_solver/models/fem/spectral_radius.hpp"

namespace cosurge::modal {
namespace {

/// Damping rate [1/s] at which a mode loses as much amplitude in a step of h [s] as by the time integration
/// of `fem`. Without it, weak coupling feeds oscillations that are faster than the windows.
double rate_of_damping(const fem::AlphaConstants& constants, double omega_squared, double h) {
  constexpr double least = 1e-3;  // least amplitude factor of a step, for rho_infinity = 0
  const double left = fem::amplitude_factor(constants, std::sqrt(omega_squared) * h);
  return -2 * std::log(std::clamp(left, least, 1.0)) / h;
}

}  // namespace

template <int dim>
ModalModel<dim>::ModalModel(const Structure<dim>& structure, const ModalParameters& parameters)
    : bodies_(structure), damping_(damping_rates(structure)), alpha_(parameters.rho_infinity) {
  for (const fem::FemBody<dim>& body : bodies_.bodies()) {
    modes_.push_back(lowest_modes(body, bodies_.material(), parameters.modes));
    weight_.emplace_back(modes_.back().shapes.transpose() * body.weight());
    states_.emplace_back(static_cast<std::size_t>(weight_.back().size()));
  }
}

template <int dim>
void ModalModel<dim>::prepare_steps(double h) {
  if (h == steps_size_) return;
  steps_.clear();
  for (std::size_t b = 0; b < modes_.size(); ++b)
    for (const double omega_squared : modes_[b].omega_squared)
      steps_.emplace_back(omega_squared, damping_[b] + rate_of_damping(alpha_, omega_squared, h), h);
  steps_size_ = h;
}

template <int dim>
int ModalModel<dim>::advance(const Window& window, const NodalLoad& load) {
  prepare_steps(window.size);
  auto step = steps_.begin();
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    const Eigen::MatrixXd& shapes = modes_[b].shapes;
    const fem::Vector first = shapes.transpose() * bodies_.of_body(b, load.first) + weight_[b];
    const fem::Vector last = shapes.transpose() * bodies_.of_body(b, load.last) + weight_[b];
    for (std::size_t i = 0; i < states_[b].size(); ++i, ++step)
      step->advance(states_[b][i], first[static_cast<long>(i)], last[static_cast<long>(i)]);
  }
  bodies_.check_motion(window, velocities());
  return 1;
}

template <int dim>
typename ModalModel<dim>::Vectors ModalModel<dim>::motion(double OscillatorState::*part) const {
  Vectors all;
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    fem::Vector amplitudes(weight_[b].size());
    for (std::size_t i = 0; i < states_[b].size(); ++i)
      amplitudes[static_cast<long>(i)] = states_[b][i].*part;
    all.emplace_back(modes_[b].shapes * amplitudes);
  }
  return all;
}

template <int dim>
void ModalModel<dim>::place(const Vectors& displacements, const Vectors& velocities) {
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    const fem::FemBody<dim>& body = bodies_.bodies()[b];
    const fem::Vector position = modes_[b].shapes.transpose() * body.momentum(displacements[b]);
    const fem::Vector velocity = modes_[b].shapes.transpose() * body.momentum(velocities[b]);
    for (std::size_t i = 0; i < states_[b].size(); ++i) {
      const auto mode = static_cast<Eigen::Index>(i);
      states_[b][i] = {.position = position[mode], .velocity = velocity[mode]};
    }
  }
}

template <int dim>
bool ModalModel<dim>::has_free_motion() const {
  return std::any_of(modes_.begin(), modes_.end(),
                     [](const Modes& modes) { return modes.omega_squared.minCoeff() <= 0; });
}

template <int dim>
fem::Vector ModalModel<dim>::deflection(std::size_t b, const fem::Vector& force) const {
  const Modes& modes = modes_[b];
  return modes.shapes * (modes.shapes.transpose() * force).cwiseQuotient(modes.omega_squared);
}

template <int dim>
Field ModalModel<dim>::acceleration_by(const Field& load) const {
  Vectors all;
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    const Eigen::MatrixXd& shapes = modes_[b].shapes;
    all.emplace_back(shapes * (shapes.transpose() * bodies_.of_body(b, load)));
  }
  return bodies_.to_nodes(all);
}

template <int dim>
std::vector<NodalMode> ModalModel<dim>::modes(int count) const {
  std::vector<NodalMode> lowest;
  for (std::size_t b = 0; b < modes_.size(); ++b)
    for (Eigen::Index i = 0; i < std::min<Eigen::Index>(count, modes_[b].omega_squared.size()); ++i) {
      Vectors shape;
      for (const Modes& modes : modes_) shape.push_back(fem::Vector::Zero(modes.shapes.rows()));
      shape[b] = modes_[b].shapes.col(i);
      lowest.push_back({.shape = bodies_.to_nodes(shape),
                        .mass = 1,
                        .omega_squared = std::max(0.0, modes_[b].omega_squared[i])});
    }
  return lowest;
}

template <int dim>
Energies ModalModel<dim>::energies() const {
  Energies sum;
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    for (std::size_t i = 0; i < states_[b].size(); ++i) {
      const auto mode = static_cast<long>(i);
      const auto& [position, velocity, ramp_increment] = states_[b][i];
      sum.kinetic += 0.5 * velocity * velocity;
      sum.elastic += 0.5 * modes_[b].omega_squared[mode] * position * position;
      sum.gravity -= weight_[b][mode] * position;
    }
  }
  return sum;
}

template <int dim>
std::vector<double> ModalModel<dim>::values() const {
  const auto largest = bodies_.deformation(displacements());
  return {largest.rotation, largest.strain, largest_deflection()};
}

/// Displacement of a node, without the free motion of the body as a whole, over the longest side of the body.
template <int dim>
double ModalModel<dim>::largest_deflection() const {
  double largest = 0;
  for (std::size_t b = 0; b < modes_.size(); ++b) {
    const fem::FemBody<dim>& body = bodies_.bodies()[b];
    fem::Vector amplitudes = fem::Vector::Zero(weight_[b].size());
    for (std::size_t i = 0; i < states_[b].size(); ++i) {
      const auto mode = static_cast<Eigen::Index>(i);
      if (modes_[b].omega_squared[mode] > 0) amplitudes[mode] = states_[b][i].position;
    }
    const Box<dim>& bounds = body.mesh().shape().bounds();
    const Field u = body.to_nodes(modes_[b].shapes * amplitudes);
    largest = std::max(largest, u.colwise().norm().maxCoeff() / (bounds.max - bounds.min).maxCoeff());
  }
  return largest;
}

template <int dim>
std::string ModalModel<dim>::save() const {
  StateWriter state;
  for (const auto& modes : states_) state.put(modes);
  return state.take();
}

template <int dim>
void ModalModel<dim>::restore(const std::string& text) {
  StateReader state(text);
  for (auto& modes : states_) {
    const std::size_t count = modes.size();
    state.get(modes);
    require(modes.size() == count, "saved state: {} modes, not {}; it belongs to another case", modes.size(),
            count);
  }
  state.finish();
}

template class ModalModel<2>;
template class ModalModel<3>;

}  // namespace cosurge::modal
