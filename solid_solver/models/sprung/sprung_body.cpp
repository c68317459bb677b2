#include "solid_solver/models/sprung/sprung_body.hpp"

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "solid_solver/shape_moments.hpp"

namespace cosurge::sprung {
template <int dim>
SprungBody<dim>::SprungBody(const Shape<dim>& shape, std::size_t index,
                            const SprungParameters<dim>& parameters, double density, const Vec<dim>& gravity,
                            const Vec<dim>& velocity)
    : shape_(shape), gravity_(gravity) {
  const ShapeMoments<dim> moments(shape_);
  pivot_ = parameters.pivot.value_or(moments.centre);
  arm_to_centre_ = moments.centre - pivot_;
  length_ = (shape_.bounds().max - shape_.bounds().min).maxCoeff();
  mass_ = parameters.mass.value_or(density * moments.volume);
  Eigen::Matrix<double, dim, nodes> slopes =
      Eigen::Matrix<double, dim, nodes>::Zero();  // slopes of the coefficients [1/m]
  slopes.col(0).setConstant(-1 / length_);
  slopes.template rightCols<dim>().diagonal().setConstant(1 / length_);
  const Coefficients centre = coefficients(moments.centre);
  nodal_mass_ =
      mass_ * (centre * centre.transpose() + slopes.transpose() * moments.second * slopes / moments.volume);
  for (std::size_t k = 0; k < dim; ++k)
    if (const std::optional<Spring>& spring = parameters.along[k])
      translations_[k] = {.free = true, .spring = *spring, .state = {.velocity = velocity[k]}};
  const Mat<dim> second =
      mass_ * (moments.second / moments.volume + arm_to_centre_ * arm_to_centre_.transpose());
  turning_.emplace(parameters.turn, second, length_);
  const bool moves =
      std::any_of(translations_.begin(), translations_.end(), [](const auto& t) { return t.free; });
  require(
      !turning_->is_free() || !moves || arm_to_centre_.isZero(1e-9 * length_),
      "solid.sprung.pivot: solid.body.{} must turn about its centre of mass where it is free to move along "
      "its axes",
      index);
}

template <int dim>
typename SprungBody<dim>::Coefficients SprungBody<dim>::coefficients(const Vec<dim>& x) const {
  Coefficients c;
  c.template tail<dim>() = (x - pivot_) / length_;
  c[0] = 1 - c.template tail<dim>().sum();
  return c;
}

template <int dim>
Field SprungBody<dim>::position() const {
  Field at = pivot_.replicate(1, nodes);
  for (int k = 0; k < dim; ++k) at(k, 1 + k) += length_;
  return at;
}

template <int dim>
int SprungBody<dim>::advance(double window, const Nodal& first, const Nodal& last) {
  ramp_increment_.setZero();
  for (int k = 0; k < dim; ++k) {
    Translation& t = translations_[static_cast<std::size_t>(k)];
    if (!t.free) continue;
    const double steady = t.spring.preload / mass_ + gravity_[k];
    OscillatorStep(t.spring.stiffness / mass_, t.spring.damping / mass_, window)
        .advance(t.state, first.row(k).sum() / mass_ + steady, last.row(k).sum() / mass_ + steady);
    ramp_increment_.row(k).setConstant(t.state.ramp_increment);
  }
  return turning_->advance(window, first, last, arm_to_centre_, mass_ * gravity_, ramp_increment_);
}

template <int dim>
std::vector<NodalMode> SprungBody<dim>::modes() const {
  std::vector<NodalMode> all;
  for (int k = 0; k < dim; ++k) {
    const Translation& translation = translations_[static_cast<std::size_t>(k)];
    if (!translation.free) continue;
    Field shape = Field::Zero(dim, nodes);
    shape.row(k).setOnes();
    all.push_back({.shape = shape, .mass = mass_, .omega_squared = translation.spring.stiffness / mass_});
  }
  for (NodalMode& mode : turning_->modes()) all.push_back(std::move(mode));
  return all;
}

template <int dim>
Field SprungBody<dim>::displacement() const {
  Nodal moved = turning_->displacement();
  for (int k = 0; k < dim; ++k)
    moved.row(k).array() += translations_[static_cast<std::size_t>(k)].state.position;
  return moved;
}

template <int dim>
Field SprungBody<dim>::velocity() const {
  Nodal v = turning_->velocity();
  for (int k = 0; k < dim; ++k) v.row(k).array() += translations_[static_cast<std::size_t>(k)].state.velocity;
  return v;
}

template <int dim>
Energies SprungBody<dim>::energies() const {
  Energies sum;
  for (const Translation& t : translations_) {
    sum.kinetic += 0.5 * mass_ * t.state.velocity * t.state.velocity;
    sum.elastic +=
        0.5 * t.spring.stiffness * t.state.position * t.state.position - t.spring.preload * t.state.position;
  }
  sum.kinetic += turning_->kinetic_energy();
  sum.elastic += turning_->spring_energy();
  sum.gravity = -mass_ * gravity_.dot(displacement() * coefficients(pivot_ + arm_to_centre_));
  return sum;
}

template <int dim>
double SprungBody<dim>::max_speed() const {
  const Field v = velocity();
  double fastest = 0;
  for (const auto& facet : shape_.facets())
    for (const Vec<dim>& x : facet) fastest = std::max(fastest, (v * coefficients(x)).norm());
  if (!shape_.is_box()) return fastest;
  const Box<dim>& box = shape_.bounds();
  for (int corner = 0; corner < 1 << dim; ++corner) {
    Vec<dim> x;
    for (int k = 0; k < dim; ++k) x[k] = (corner >> k & 1) != 0 ? box.max[k] : box.min[k];
    fastest = std::max(fastest, (v * coefficients(x)).norm());
  }
  return fastest;
}

template <int dim>
void SprungBody<dim>::save(StateWriter& state) const {
  for (const Translation& t : translations_) {
    state.put(t.state.position);
    state.put(t.state.velocity);
  }
  turning_->save(state);
  state.put(ramp_increment_);
}

template <int dim>
void SprungBody<dim>::restore(StateReader& state) {
  for (Translation& t : translations_) {
    state.get(t.state.position);
    state.get(t.state.velocity);
  }
  turning_->restore(state);
  state.get(ramp_increment_);
}

template class SprungBody<2>;
template class SprungBody<3>;

}  // namespace cosurge::sprung
