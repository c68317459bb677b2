#include "solid_solver/models/mps/mps_body.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "solid_solver/damping.hpp"
#include "solid_solver/models/particles/highest_frequency.hpp"

namespace cosurge::mps {
namespace {

// Added to every r^2, so that a particle that happens to coincide with a void slot, whose pair has no weight,
// does not divide by zero.
constexpr double not_zero = 1e-200;

using particles::at;
using particles::Neighbor;

}  // namespace

template <int dim>
MpsBody<dim>::MpsBody(const Body<dim>& body, std::size_t index, const particles::Stencil<dim>& stencil,
                      const particles::Substance<dim>& substance, MpsParameters::Pairs pairs)
    : Base(body, index, stencil, substance),
      weights_(pairs == MpsParameters::Pairs::paper ? lattice_weights(grid_, stencil)
                                                    : whole_weights(grid_, stencil)),
      dilatational_(substance.material.lambda() > 0) {
  const Elasticity& material = substance.material;
  for (const Neighbor<dim>& n : stencil.neighbors) {
    const double d_n0 = dim / stencil.n0;
    Bond bond{.shift = grid_.shift(n.offset),
              .r0 = {},
              .length = n.length,
              .spring = 4 * d_n0 * material.mu() / material.density / (n.length * n.length),
              .stretch = d_n0 / n.length,
              .pull = particles::lambda_of_particles(material) / material.density * d_n0 / n.length};
    for (int k = 0; k < dim; ++k) bond.r0[k] = n.r0[k];
    bonds_.push_back(bond);
  }
  const Slots zero = Slots::Zero(grid_.slots());
  dilatation_ = turns_ = zero;
  spin_.fill(zero);
  rotation_.fill(zero);
  rotation_[0] += 1;
  later_displacement_ = displacement_;
  later_rotation_ = rotation_;
  for (std::size_t p = 0; p < grid_.positions().size(); ++p) turns_[grid_.slot(p)] = grid_.held(p) ? 0 : 1;
  if (material.lambda() > particles::lambda_of_particles(material))
    cells_.emplace(grid_, weights_.dilates, stencil.spacing, material);
}

template <int dim>
void MpsBody<dim>::advance(int substeps, double dt) {
  for (Slots& increment : ramp_increment_) increment.setZero();
  for (int k = 0; k < substeps; ++k) {
    const double load_fraction = (k + 0.5) / substeps;
    const Pose strained = substance_.retardation > 0 ? look_ahead() : present();
    if (dilatational_) measure_dilatation(strained);
    if (cells_) cells_->measure(displacement_, velocity_, substance_.retardation);
    accelerate(strained, dt, load_fraction);
    move(dt, load_fraction);
  }
}

template <int dim>
typename MpsBody<dim>::Rot MpsBody<dim>::Pose::rotation_at(Eigen::Index i) const {
  Rot at_i;
  for (int k = 0; k < Rot::components; ++k) at_i.q[k] = at(rotation[k], i);
  return at_i;
}

/// Extrapolates the pose by the retardation time with the present velocities (S40).
template <int dim>
typename MpsBody<dim>::Pose MpsBody<dim>::look_ahead() {
  const double tau = substance_.retardation;
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    for (int k = 0; k < dim; ++k)
      at(later_displacement_[k], i) = at(displacement_[k], i) + tau * at(velocity_[k], i);
    std::array<Lanes, Rot::spins> angle;
    for (int k = 0; k < Rot::spins; ++k) angle[k] = tau * at(spin_[k], i);
    const Rot turned = present().rotation_at(i).turned(angle);
    for (int k = 0; k < Rot::components; ++k) at(later_rotation_[k], i) = turned.q[k];
  }
  return {later_displacement_, later_rotation_};
}

template <int dim>
void MpsBody<dim>::measure_dilatation(const Pose& strained) const {
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    Lanes sum = Lanes::Zero();
    for (std::size_t b = 0; b < bonds_.size(); ++b) {
      const Bond& bond = bonds_[b];
      LaneVec<dim> r = Base::difference(strained.displacement, i, i + bond.shift);
      const Lanes reach = at(weights_.pairs[b].reach, i);
      Lanes square = Lanes::Constant(not_zero);
      for (int k = 0; k < dim; ++k) {
        r[k] += bond.r0[k] * reach;
        square += r[k] * r[k];
      }
      sum +=
          bond.stretch * at(weights_.pairs[b].stretch, i) * (square * square.rsqrt() - bond.length * reach);
    }
    at(dilatation_, i) = sum * at(weights_.dilates, i);
  }
}

template <int dim>
void MpsBody<dim>::measure_at_rest() const {
  if (dilatational_) measure_dilatation(present());
  if (cells_) cells_->measure(displacement_, velocity_, 0);
}

template <int dim>
typename MpsBody<dim>::Acceleration MpsBody<dim>::internal_acceleration(const Pose& strained,
                                                                        Eigen::Index i) const {
  Acceleration a;
  if (cells_)
    a.linear = cells_->acceleration(i);
  else
    for (Lanes& component : a.linear) component.setZero();
  for (Lanes& component : a.angular) component.setZero();
  a.spring_energy.setZero();
  const Rot rotation = strained.rotation_at(i);
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    const Bond& bond = bonds_[b];
    const auto& weight = weights_.pairs[b];
    const Eigen::Index j = i + bond.shift;
    const typename Rot::Pair both = rotation.with(strained.rotation_at(j));
    const LaneVec<dim> unstrained = both.turn(bond.r0);
    const LaneVec<dim> later = Base::difference(strained.displacement, i, j);
    LaneVec<dim> r = Base::difference(displacement_, i, j), force;
    const Lanes spring = bond.spring * at(weight.spring, i), reach = at(weight.reach, i);
    Lanes square = Lanes::Constant(not_zero);
    for (int k = 0; k < dim; ++k) {
      r[k] += bond.r0[k] * reach;
      const Lanes u = later[k] + reach * (bond.r0[k] - unstrained[k]);
      force[k] = spring * u;
      a.linear[k] += force[k];
      a.spring_energy += force[k] * u;
      square += r[k] * r[k];
    }
    const auto couple = both.share(cross(r, force));
    for (int k = 0; k < Rot::spins; ++k) a.angular[k] += couple[k];
    if (weights_.bending > 0) {
      const Lanes stiffness = weights_.bending * spring;
      const auto twist = both.twist();
      for (int k = 0; k < Rot::spins; ++k) a.angular[k] += 2 * stiffness * twist[k];
      a.spring_energy += 2 * stiffness * both.one_minus_cosine();
    }
    if (!dilatational_) continue;
    const Lanes pull =
        bond.pull * at(weight.stretch, i) * (at(dilatation_, i) + at(dilatation_, j)) * square.rsqrt();
    for (int k = 0; k < dim; ++k) a.linear[k] += pull * r[k];
  }
  // Half of each pair's couple, over the moment of inertia m l0^2 / 6 (S9, S10).
  for (Lanes& component : a.angular) component *= 3 / (stencil_.spacing * stencil_.spacing);
  return a;
}

template <int dim>
void MpsBody<dim>::accelerate(const Pose& strained, double dt, double load_fraction) {
  const double left = std::exp(-substance_.damping_rate * dt);
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Acceleration a = internal_acceleration(strained, i);
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
    const Rot turned = present().rotation_at(i).turned(angle);
    for (int k = 0; k < Rot::components; ++k) at(rotation_[k], i) = turned.q[k];
  }
}

template <int dim>
void MpsBody<dim>::place(std::size_t particle, const Vec<dim>& displacement, const Axial& rotation,
                         const Vec<dim>& velocity, const Axial& spin) {
  Base::place(particle, displacement, velocity);
  const Eigen::Index i = grid_.slot(particle);
  if (turns_[i] == 0) return;
  const double angle = rotation.norm();
  rotation_[0][i] = std::cos(angle / 2);
  for (int k = 0; k < Rot::spins; ++k) {
    rotation_[k + 1][i] = angle == 0 ? 0 : std::sin(angle / 2) * rotation[k] / angle;
    spin_[k][i] = spin[k];
  }
}

template <int dim>
double MpsBody<dim>::highest_frequency() const {
  // Coordinates of equal mass: displacements, and rotations times their radius of gyration.
  const double gyration = stencil_.spacing / std::sqrt(6.0);
  MpsBody moved = *this;
  struct Unknown {
    double* coordinate;
    int component;  // component of the acceleration; angular components come last
    Eigen::Index slot;
  };
  std::vector<Unknown> unknowns;
  for (std::size_t p = 0; p < grid_.positions().size(); ++p) {
    const Eigen::Index slot = grid_.slot(p);
    for (int k = 0; k < dim; ++k)
      if (free_[k][slot] != 0) unknowns.push_back({&moved.displacement_[k][slot], k, slot});
    for (int k = 0; k < Rot::spins; ++k)
      if (turns_[slot] != 0) unknowns.push_back({&moved.rotation_[k + 1][slot], dim + k, slot});
  }
  return particles::highest_frequency(unknowns.size(), [&](const Eigen::VectorXd& x) {
    // Strains so small that their squares are negligible.
    const double scale = 1e-7 * stencil_.spacing / x.norm();
    for (std::size_t m = 0; m < unknowns.size(); ++m)
      *unknowns[m].coordinate = scale * x[m] * (unknowns[m].component < dim ? 1 : 0.5 / gyration);
    moved.measure_at_rest();
    std::vector<Slots> a(dim + Rot::spins, Slots::Zero(grid_.slots()));
    for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
      const Acceleration lanes = moved.internal_acceleration(moved.present(), i);
      for (int k = 0; k < dim; ++k) at(a[k], i) = lanes.linear[k];
      for (int k = 0; k < Rot::spins; ++k) at(a[dim + k], i) = gyration * lanes.angular[k];
    }
    Eigen::VectorXd y(x.size());
    for (std::size_t m = 0; m < unknowns.size(); ++m)
      y[m] = -a[unknowns[m].component][unknowns[m].slot] / scale;
    return y;
  });
}

template <int dim>
Field MpsBody<dim>::acceleration() const {
  std::array<Slots, dim> values;
  values.fill(Slots::Zero(grid_.slots()));
  measure_at_rest();
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Acceleration a = internal_acceleration(present(), i);
    for (int k = 0; k < dim; ++k) at(values[k], i) = a.linear[k];
  }
  return this->gather(values);
}

template <int dim>
typename MpsBody<dim>::Axial MpsBody<dim>::angular_momentum() const {
  const Field q = this->displacement(), v = this->velocity();
  const double gyration_squared = stencil_.spacing * stencil_.spacing / 6;
  Axial sum = Axial::Zero();
  for (Eigen::Index p = 0; p < this->particles(); ++p) {
    const Vec<dim> x = grid_.positions()[p] + q.col(p), speed = v.col(p);
    if constexpr (dim == 2) sum[0] += x[0] * speed[1] - x[1] * speed[0];
    if constexpr (dim == 3) sum += x.cross(speed);
    for (int k = 0; k < Rot::spins; ++k) sum[k] += gyration_squared * spin_[k][grid_.slot(p)];
  }
  return mass_ * sum;
}

template <int dim>
Energies MpsBody<dim>::energies(double dt) const {
  const double inertia = stencil_.spacing * stencil_.spacing / 6;
  const double lambda = particles::lambda_of_particles(substance_.material) / substance_.material.density;
  Lanes kinetic = Lanes::Zero(), elastic = Lanes::Zero(), gravity = Lanes::Zero();
  measure_at_rest();
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Acceleration a = internal_acceleration(present(), i);
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
    elastic += at(present_, i) * (0.25 * a.spring_energy + 0.5 * lambda * at(dilatation_, i).square());
    if (cells_) elastic += cells_->energy(i);
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

template <int dim>
std::unique_ptr<SolidModel> make_mps(const Structure<dim>& structure, const MpsParameters& parameters) {
  return particles::make_particle_model<dim>(
      structure, parameters.particles, "solid.mps",
      [&](const Body<dim>& body, std::size_t number, const particles::Stencil<dim>& stencil,
          const particles::Substance<dim>& substance) {
        return std::make_unique<MpsBody<dim>>(body, number, stencil, substance, parameters.pairs);
      });
}

template class MpsBody<2>;
template class MpsBody<3>;
template std::unique_ptr<SolidModel> make_mps<2>(const Structure<2>&, const MpsParameters&);
template std::unique_ptr<SolidModel> make_mps<3>(const Structure<3>&, const MpsParameters&);

}  // namespace cosurge::mps
