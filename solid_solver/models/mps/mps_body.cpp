#include "solid_solver/models/mps/mps_body.hpp"

#include <cmath>

namespace cosurge::mps {
namespace {

// Added to every r^2: a particle that happens to lie on a void slot, whose pair counts nothing, must not
// divide by zero.
constexpr double not_zero = 1e-200;

Eigen::Map<const Lanes> at(const Eigen::ArrayXd& values, Eigen::Index i) {
  return Eigen::Map<const Lanes>(values.data() + i);
}

Eigen::Map<Lanes> at(Eigen::ArrayXd& values, Eigen::Index i) { return Eigen::Map<Lanes>(values.data() + i); }

}  // namespace

template <int dim>
MpsBody<dim>::MpsBody(const v1::Body& body, const Stencil<dim>& stencil, const Elasticity& material,
                      const Vec<dim>& gravity)
    : grid_(body, stencil),
      stencil_(stencil),
      material_(material),
      gravity_(gravity),
      mass_(material.density * std::pow(stencil.spacing, dim)),
      dilatational_(material.lambda() > 0) {
  for (const Neighbor<dim>& n : stencil.neighbors) {
    const double d_n0 = dim / stencil.n0;
    Bond bond{.shift = grid_.shift(n.offset),
              .r0 = {},
              .length = n.length,
              .spring = 4 * d_n0 * material.mu() / material.density * n.w / (n.length * n.length),
              .stretch = d_n0 * n.w / n.length,
              .pull = material.lambda() / material.density * d_n0 * n.w / n.length};
    for (int k = 0; k < dim; ++k) bond.r0[k] = n.r0[k];
    bonds_.push_back(bond);
  }
  const Slots zero = Slots::Zero(grid_.slots());
  present_ = free_ = dilatation_ = zero;
  for (auto* field : {&displacement_, &velocity_, &load_, &load_change_, &ramp_increment_}) field->fill(zero);
  spin_.fill(zero);
  for (int k = 0; k < Rot::components; ++k) rotation_[k] = zero + Rot::identity()[k];
  for (std::size_t p = 0; p < grid_.positions().size(); ++p) {
    present_[grid_.slot(p)] = 1;
    free_[grid_.slot(p)] = grid_.held(p) ? 0 : 1;
  }
  set_load(Field::Zero(dim, particles()), Field::Zero(dim, particles()));
}

template <int dim>
void MpsBody<dim>::set_load(const Eigen::Ref<const Field>& first, const Eigen::Ref<const Field>& last) {
  for (Eigen::Index p = 0; p < particles(); ++p) {
    for (int k = 0; k < dim; ++k) {
      load_[k][grid_.slot(p)] = first(k, p) / mass_ + gravity_[k];
      load_change_[k][grid_.slot(p)] = (last(k, p) - first(k, p)) / mass_;
    }
  }
}

template <int dim>
void MpsBody<dim>::advance(int substeps, double dt) {
  for (Slots& increment : ramp_increment_) increment.setZero();
  for (int k = 0; k < substeps; ++k) {
    const double load_fraction = (k + 0.5) / substeps;
    if (dilatational_) measure_dilatation();
    accelerate(dt, load_fraction);
    move(dt, load_fraction);
  }
}

template <int dim>
LaneVec<dim> MpsBody<dim>::relative_displacement(Eigen::Index i, Eigen::Index j) const {
  LaneVec<dim> difference;
  for (int k = 0; k < dim; ++k) difference[k] = at(displacement_[k], j) - at(displacement_[k], i);
  return difference;
}

template <int dim>
typename MpsBody<dim>::Rot MpsBody<dim>::rotation_at(Eigen::Index i) const {
  if constexpr (dim == 2) return {at(rotation_[0], i), at(rotation_[1], i)};
}

template <int dim>
void MpsBody<dim>::measure_dilatation() const {
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    Lanes sum = Lanes::Zero();
    for (const Bond& bond : bonds_) {
      const Eigen::Index j = i + bond.shift;
      LaneVec<dim> r = relative_displacement(i, j);
      Lanes square = Lanes::Constant(not_zero);
      for (int k = 0; k < dim; ++k) {
        r[k] += bond.r0[k];
        square += r[k] * r[k];
      }
      sum += bond.stretch * at(present_, j) * (square * square.rsqrt() - bond.length);
    }
    at(dilatation_, i) = sum * at(present_, i);
  }
}

template <int dim>
typename MpsBody<dim>::Acceleration MpsBody<dim>::internal_acceleration(Eigen::Index i) const {
  Acceleration a;
  for (Lanes& component : a.linear) component.setZero();
  for (Lanes& component : a.angular) component.setZero();
  a.spring_energy.setZero();
  const Rot rotation = rotation_at(i);
  for (const Bond& bond : bonds_) {
    const Eigen::Index j = i + bond.shift;
    const LaneVec<dim> unstrained = rotation.mean(rotation_at(j)).apply(bond.r0);
    LaneVec<dim> r = relative_displacement(i, j), force;
    const Lanes present = at(present_, j);
    const Lanes spring = bond.spring * present;
    Lanes square = Lanes::Constant(not_zero);
    for (int k = 0; k < dim; ++k) {
      r[k] += bond.r0[k];
      const Lanes u = r[k] - unstrained[k];
      force[k] = spring * u;
      a.linear[k] += force[k];
      a.spring_energy += force[k] * u;
      square += r[k] * r[k];
    }
    const auto couple = cross(r, force);
    for (int k = 0; k < Rot::spins; ++k) a.angular[k] += couple[k];
    if (!dilatational_) continue;
    const Lanes pull = bond.pull * present * (at(dilatation_, i) + at(dilatation_, j)) * square.rsqrt();
    for (int k = 0; k < dim; ++k) a.linear[k] += pull * r[k];
  }
  // Half of each pair's couple, over the moment of inertia m l0^2 / 6 (S9, S10).
  for (Lanes& component : a.angular) component *= 3 / (stencil_.spacing * stencil_.spacing);
  return a;
}

template <int dim>
void MpsBody<dim>::accelerate(double dt, double load_fraction) {
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Acceleration a = internal_acceleration(i);
    const Lanes step = dt * at(free_, i);
    for (int k = 0; k < dim; ++k)
      at(velocity_[k], i) += step * (a.linear[k] + at(load_[k], i) + load_fraction * at(load_change_[k], i));
    for (int k = 0; k < Rot::spins; ++k) at(spin_[k], i) += step * a.angular[k];
  }
}

template <int dim>
void MpsBody<dim>::move(double dt, double load_fraction) {
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    for (int k = 0; k < dim; ++k) {
      const Lanes increment = dt * at(velocity_[k], i);
      at(displacement_[k], i) += increment;
      at(ramp_increment_[k], i) += load_fraction * increment;
    }
    std::array<Lanes, Rot::spins> angle;
    for (int k = 0; k < Rot::spins; ++k) angle[k] = dt * at(spin_[k], i);
    const Rot turned = rotation_at(i).turned(angle);
    at(rotation_[0], i) = turned.c;
    at(rotation_[1], i) = turned.s;
  }
}

template <int dim>
void MpsBody<dim>::place(std::size_t particle, const Vec<dim>& displacement, double rotation,
                         const Vec<dim>& velocity, double spin) {
  const Eigen::Index i = grid_.slot(particle);
  if (grid_.held(particle)) return;
  for (int k = 0; k < dim; ++k) {
    displacement_[k][i] = displacement[k];
    velocity_[k][i] = velocity[k];
  }
  rotation_[0][i] = std::cos(rotation / 2);
  rotation_[1][i] = std::sin(rotation / 2);
  spin_[0][i] = spin;
}

template <int dim>
Field MpsBody<dim>::gather(const std::array<Slots, dim>& values) const {
  Field field(dim, particles());
  for (Eigen::Index p = 0; p < particles(); ++p)
    for (int k = 0; k < dim; ++k) field(k, p) = values[k][grid_.slot(p)];
  return field;
}

template <int dim>
Field MpsBody<dim>::displacement() const {
  return gather(displacement_);
}

template <int dim>
Field MpsBody<dim>::velocity() const {
  return gather(velocity_);
}

template <int dim>
Field MpsBody<dim>::ramp_increment() const {
  return gather(ramp_increment_);
}

template <int dim>
Field MpsBody<dim>::acceleration() const {
  std::array<Slots, dim> values;
  values.fill(Slots::Zero(grid_.slots()));
  if (dilatational_) measure_dilatation();
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Acceleration a = internal_acceleration(i);
    for (int k = 0; k < dim; ++k) at(values[k], i) = a.linear[k];
  }
  return gather(values);
}

template <int dim>
double MpsBody<dim>::angular_momentum() const {
  const Field q = displacement(), v = velocity();
  const double inertia = mass_ * stencil_.spacing * stencil_.spacing / 6;
  double sum = 0;
  for (Eigen::Index p = 0; p < particles(); ++p) {
    const Vec<dim> x = grid_.positions()[p] + q.col(p);
    sum += mass_ * (x[0] * v(1, p) - x[1] * v(0, p)) + inertia * spin_[0][grid_.slot(p)];
  }
  return sum;
}

template <int dim>
Energies MpsBody<dim>::energies(double dt) const {
  const double inertia = stencil_.spacing * stencil_.spacing / 6;
  Lanes kinetic = Lanes::Zero(), elastic = Lanes::Zero(), gravity = Lanes::Zero();
  if (dilatational_) measure_dilatation();
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Acceleration a = internal_acceleration(i);
    const Lanes half_step = 0.5 * dt * at(free_, i);
    for (int k = 0; k < dim; ++k) {
      const Lanes load = at(load_[k], i) + at(load_change_[k], i);
      const Lanes v = at(velocity_[k], i) + half_step * (a.linear[k] + load);
      kinetic += 0.5 * v * v;
      gravity -= gravity_[k] * at(displacement_[k], i);
    }
    for (int k = 0; k < Rot::spins; ++k) {
      const Lanes spin = at(spin_[k], i) + half_step * a.angular[k];
      kinetic += 0.5 * inertia * spin * spin;
    }
    // A pair's energy spring |u|^2 / 2 is halved between its two particles.
    elastic += at(present_, i) * (0.25 * a.spring_energy +
                                  0.5 * material_.lambda() / material_.density * at(dilatation_, i).square());
  }
  return {
      .kinetic = mass_ * kinetic.sum(), .elastic = mass_ * elastic.sum(), .gravity = mass_ * gravity.sum()};
}

template <int dim>
Mat<dim> MpsBody<dim>::deformation_gradient(std::size_t particle) const {
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
void MpsBody<dim>::save(StateWriter& state) const {
  for (const auto* field : {&displacement_, &velocity_, &load_, &load_change_, &ramp_increment_})
    for (const Slots& values : *field) state.put(values);
  for (const Slots& values : rotation_) state.put(values);
  for (const Slots& values : spin_) state.put(values);
}

template <int dim>
void MpsBody<dim>::restore(StateReader& state) {
  for (auto* field : {&displacement_, &velocity_, &load_, &load_change_, &ramp_increment_})
    for (Slots& values : *field) state.get(values);
  for (Slots& values : rotation_) state.get(values);
  for (Slots& values : spin_) state.get(values);
}

template class MpsBody<2>;

}  // namespace cosurge::mps
