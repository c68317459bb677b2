#include "solid_solver/models/particles/particle_body.hpp"

#include <Eigen/LU>
#include <cmath>

namespace cosurge::particles {

template <int dim>
ParticleBody<dim>::ParticleBody(const Body<dim>& body, std::size_t index, const Stencil<dim>& stencil,
                                const Substance<dim>& substance)
    : grid_(body, index, stencil),
      stencil_(stencil),
      substance_(substance),
      mass_(substance.material.density * std::pow(stencil.spacing, dim)) {
  const Slots zero = Slots::Zero(grid_.slots());
  present_ = zero;
  for (auto* field : {&free_, &displacement_, &velocity_, &load_, &load_change_, &ramp_increment_})
    field->fill(zero);
  for (std::size_t p = 0; p < grid_.positions().size(); ++p) {
    present_[grid_.slot(p)] = 1;
    for (std::size_t k = 0; k < dim; ++k) free_[k][grid_.slot(p)] = grid_.held_axes(p)[k] ? 0 : 1;
  }
  set_load(Field::Zero(dim, particles()), Field::Zero(dim, particles()));
}

template <int dim>
void ParticleBody<dim>::set_load(const Eigen::Ref<const Field>& first, const Eigen::Ref<const Field>& last) {
  for (Eigen::Index p = 0; p < particles(); ++p) {
    for (int k = 0; k < dim; ++k) {
      load_[k][grid_.slot(p)] = first(k, p) / mass_ + substance_.gravity[k];
      load_change_[k][grid_.slot(p)] = (last(k, p) - first(k, p)) / mass_;
    }
  }
}

template <int dim>
Field ParticleBody<dim>::acceleration_by(const Eigen::Ref<const Field>& load) const {
  Field a(dim, particles());
  for (Eigen::Index p = 0; p < particles(); ++p)
    for (int k = 0; k < dim; ++k) a(k, p) = free_[k][grid_.slot(p)] * load(k, p) / mass_;
  return a;
}

template <int dim>
LaneVec<dim> ParticleBody<dim>::difference(const std::array<Slots, dim>& values, Eigen::Index i,
                                           Eigen::Index j) {
  LaneVec<dim> by_axis;
  for (int k = 0; k < dim; ++k) by_axis[k] = at(values[k], j) - at(values[k], i);
  return by_axis;
}

template <int dim>
void ParticleBody<dim>::drift(Eigen::Index i, double dt, double load_fraction) {
  for (int k = 0; k < dim; ++k) {
    const Lanes increment = dt * at(velocity_[k], i);
    at(displacement_[k], i) += increment;
    at(ramp_increment_[k], i) += load_fraction * increment;
  }
}

template <int dim>
void ParticleBody<dim>::place(std::size_t particle, const Vec<dim>& displacement, const Vec<dim>& velocity) {
  const Eigen::Index i = grid_.slot(particle);
  for (int k = 0; k < dim; ++k) {
    displacement_[k][i] = displacement[k] * free_[k][i];
    velocity_[k][i] = velocity[k] * free_[k][i];
  }
}

template <int dim>
Field ParticleBody<dim>::gather(const std::array<Slots, dim>& values) const {
  Field field(dim, particles());
  for (Eigen::Index p = 0; p < particles(); ++p)
    for (int k = 0; k < dim; ++k) field(k, p) = values[k][grid_.slot(p)];
  return field;
}

template <int dim>
Mat<dim> ParticleBody<dim>::deformation_gradient(std::size_t particle) const {
  const Eigen::Index i = grid_.slot(particle);
  Mat<dim> gradient = Mat<dim>::Zero(), shape = Mat<dim>::Zero();
  for (const Neighbor<dim>& n : stencil_.neighbors) {
    const Eigen::Index j = i + grid_.shift(n.offset);
    const double w = n.w * present_[j];
    Vec<dim> r = n.r0;
    for (int k = 0; k < dim; ++k) r[k] += displacement_[k][j] - displacement_[k][i];
    gradient += w * r * n.r0.transpose();
    shape += w * n.r0 * n.r0.transpose();
  }
  const Eigen::FullPivLU<Mat<dim>> factors(shape);
  if (!factors.isInvertible()) return Mat<dim>::Identity();
  return gradient * factors.inverse();
}

template <int dim>
void ParticleBody<dim>::save(StateWriter& state) const {
  for (const auto* field : {&displacement_, &velocity_, &load_, &load_change_, &ramp_increment_})
    for (const Slots& values : *field) state.put(values);
}

template <int dim>
void ParticleBody<dim>::restore(StateReader& state) {
  for (auto* field : {&displacement_, &velocity_, &load_, &load_change_, &ramp_increment_})
    for (Slots& values : *field) state.get(values);
}

template class ParticleBody<2>;
template class ParticleBody<3>;

}  // namespace cosurge::particles
