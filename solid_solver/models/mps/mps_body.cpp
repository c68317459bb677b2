#include "solid_solver/models/mps/mps_body.hpp"

#include <cmath>

#include "solid_solver/damping.hpp"

namespace cosurge::mps {
namespace {

// Added to every r^2: a particle that happens to lie on a void slot, whose pair counts nothing, must not
// divide by zero.
constexpr double not_zero = 1e-200;

using particles::at;
using particles::Neighbor;

}  // namespace

template <int dim>
MpsBody<dim>::MpsBody(const v1::Body& body, int index, const particles::Stencil<dim>& stencil,
                      const particles::Substance<dim>& substance)
    : Base(body, index, stencil, substance), dilatational_(substance.material.lambda() > 0) {
  const Elasticity& material = substance.material;
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
  dilatation_ = turns_ = zero;
  spin_.fill(zero);
  for (int k = 0; k < Rot::components; ++k) rotation_[k] = zero + Rot::identity()[k];
  for (std::size_t p = 0; p < grid_.positions().size(); ++p) turns_[grid_.slot(p)] = grid_.held(p) ? 0 : 1;
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
typename MpsBody<dim>::Rot MpsBody<dim>::rotation_at(Eigen::Index i) const {
  if constexpr (dim == 2) return {at(rotation_[0], i), at(rotation_[1], i)};
}

template <int dim>
void MpsBody<dim>::measure_dilatation() const {
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    Lanes sum = Lanes::Zero();
    for (const Bond& bond : bonds_) {
      const Eigen::Index j = i + bond.shift;
      LaneVec<dim> r = this->relative_displacement(i, j);
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
    LaneVec<dim> r = this->relative_displacement(i, j), force;
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
  const double left = std::exp(-substance_.damping_rate * dt);
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Acceleration a = internal_acceleration(i);
    for (int k = 0; k < dim; ++k) {
      const Lanes load = at(load_[k], i) + load_fraction * at(load_change_[k], i);
      at(velocity_[k], i) = left * at(velocity_[k], i) + dt * at(free_[k], i) * (a.linear[k] + load);
    }
    for (int k = 0; k < Rot::spins; ++k)
      at(spin_[k], i) = left * at(spin_[k], i) + dt * at(turns_, i) * a.angular[k];
  }
}

template <int dim>
void MpsBody<dim>::move(double dt, double load_fraction) {
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    this->drift(i, dt, load_fraction);
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
  Base::place(particle, displacement, velocity);
  const Eigen::Index i = grid_.slot(particle);
  if (turns_[i] == 0) return;
  rotation_[0][i] = std::cos(rotation / 2);
  rotation_[1][i] = std::sin(rotation / 2);
  spin_[0][i] = spin;
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
  return this->gather(values);
}

template <int dim>
double MpsBody<dim>::angular_momentum() const {
  const Field q = this->displacement(), v = this->velocity();
  const double inertia = mass_ * stencil_.spacing * stencil_.spacing / 6;
  double sum = 0;
  for (Eigen::Index p = 0; p < this->particles(); ++p) {
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
    for (int k = 0; k < dim; ++k) {
      const Lanes half_step = 0.5 * dt * at(free_[k], i);
      const Lanes load = at(load_[k], i) + at(load_change_[k], i);
      const Lanes v = at(velocity_[k], i) + half_step * (a.linear[k] + load);
      kinetic += 0.5 * v * v;
      gravity -= substance_.gravity[k] * at(displacement_[k], i);
    }
    for (int k = 0; k < Rot::spins; ++k) {
      const Lanes spin = at(spin_[k], i) + 0.5 * dt * at(turns_, i) * a.angular[k];
      kinetic += 0.5 * inertia * spin * spin;
    }
    // A pair's energy spring |u|^2 / 2 is halved between its two particles.
    elastic += at(present_, i) *
               (0.25 * a.spring_energy + 0.5 * substance_.material.lambda() / substance_.material.density *
                                             at(dilatation_, i).square());
  }
  return {
      .kinetic = mass_ * kinetic.sum(), .elastic = mass_ * elastic.sum(), .gravity = mass_ * gravity.sum()};
}

template <int dim>
void MpsBody<dim>::save(StateWriter& state) const {
  Base::save(state);
  for (const Slots& values : rotation_) state.put(values);
  for (const Slots& values : spin_) state.put(values);
}

template <int dim>
void MpsBody<dim>::restore(StateReader& state) {
  Base::restore(state);
  for (Slots& values : rotation_) state.get(values);
  for (Slots& values : spin_) state.get(values);
}

std::unique_ptr<SolidModel> make_mps(const v1::Solid& solid, double spacing, const Vec<2>& gravity) {
  const particles::Stencil<2> stencil = particles::full_stencil<2>(spacing, solid.mps().re());
  const Elasticity material = elasticity_of<2>(solid);
  const std::vector<double> damping = damping_rates<2>(solid);
  particles::ParticleModel<2>::Bodies bodies;
  for (int b = 0; b < solid.body_size(); ++b)
    bodies.push_back(std::make_unique<MpsBody<2>>(
        solid.body(b), b, stencil,
        particles::Substance<2>{.material = material, .gravity = gravity, .damping_rate = damping[b]}));
  return std::make_unique<particles::ParticleModel<2>>(
      std::move(bodies), material, spacing,
      particles::ParticleModel<2>::Steps{.key = "solid.mps",
                                         .stable = 2 / particles::highest_frequency(stencil, material),
                                         .fraction = solid.mps().step_fraction(),
                                         .fixed = solid.mps().substep()});
}

template class MpsBody<2>;

}  // namespace cosurge::mps
