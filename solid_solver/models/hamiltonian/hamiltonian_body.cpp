#include "solid_solver/models/hamiltonian/hamiltonian_body.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solid_solver/damping.hpp"
#include "solid_solver/models/particles/highest_frequency.hpp"

namespace cosurge::hamiltonian {
namespace {

using particles::at;
using particles::Lanes;

}  // namespace

template <int dim>
HamiltonianBody<dim>::HamiltonianBody(const Body<dim>& body, std::size_t index,
                                      const particles::Stencil<dim>& stencil,
                                      const particles::Substance<dim>& substance, double stabilisation)
    : Base(body, index, stencil, substance), lambda_(particles::lambda_of_particles(substance.material)) {
  double second_moment = 0;
  for (const auto& n : stencil.neighbors) {
    Neighbor neighbor{.shift = grid_.shift(n.offset), .w = n.w, .r0 = {}};
    for (int k = 0; k < dim; ++k) neighbor.r0[k] = n.w * n.r0[k];
    neighbors_.push_back(neighbor);
    second_moment += n.w * n.length * n.length;
  }
  const Elasticity& material = substance.material;
  hold_ = 2 * stabilisation * material.young_modulus * dim / (second_moment * material.density);
  const Slots zero = Slots::Zero(grid_.slots());
  weight_ = zero;
  first_moment_.fill(zero);
  acceleration_.fill(zero);
  for (auto* tensors : {&inverse_shape_, &pull_, &gradient_})
    for (auto& row : *tensors) row.fill(zero);
  sum_geometry();
  if (material.lambda() > lambda_) cells_.emplace(grid_, present_, stencil.spacing, material);
}

template <int dim>
void HamiltonianBody<dim>::sum_geometry() {
  for (std::size_t p = 0; p < grid_.positions().size(); ++p) {
    const Eigen::Index i = grid_.slot(p);
    Mat<dim> shape = Mat<dim>::Zero();
    for (const auto& n : stencil_.neighbors) {
      const double w = n.w * present_[i + grid_.shift(n.offset)];
      weight_[i] += w;
      for (int k = 0; k < dim; ++k) first_moment_[k][i] += w * n.r0[k];
      shape += w * n.r0 * n.r0.transpose();
    }
    const Eigen::FullPivLU<Mat<dim>> factors(shape);
    if (!factors.isInvertible()) continue;  // the end of a clamp, without a strain of its own
    const Mat<dim> inverse = factors.inverse();
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) inverse_shape_[a][b][i] = inverse(a, b);
  }
}

template <int dim>
typename HamiltonianBody<dim>::Tensor HamiltonianBody<dim>::displacement_gradient(const Vectors& u,
                                                                                  Eigen::Index i) const {
  Tensor sum, H;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) sum[a][b] = -at(u[a], i) * at(first_moment_[b], i);
  for (const Neighbor& n : neighbors_) {
    for (int a = 0; a < dim; ++a) {
      const Lanes moved = at(u[a], i + n.shift);
      for (int b = 0; b < dim; ++b) sum[a][b] += n.r0[b] * moved;
    }
  }
  for (int a = 0; a < dim; ++a) {
    for (int b = 0; b < dim; ++b) {
      H[a][b] = sum[a][0] * at(inverse_shape_[0][b], i);
      for (int c = 1; c < dim; ++c) H[a][b] += sum[a][c] * at(inverse_shape_[c][b], i);
    }
  }
  return H;
}

/// S = lambda tr(E) I + 2 mu E of H, and tr(E S) / 2.
template <std::size_t dim>
struct Stress {
  std::array<std::array<Lanes, dim>, dim> S;
  Lanes energy;

  Stress(const std::array<std::array<Lanes, dim>, dim>& H, double lambda, double mu) {
    Lanes trace = Lanes::Zero();
    for (std::size_t a = 0; a < dim; ++a) {
      for (std::size_t b = a; b < dim; ++b) {
        Lanes E = H[a][b] + H[b][a];
        for (std::size_t c = 0; c < dim; ++c) E += H[c][a] * H[c][b];
        if (a == b) trace += 0.5 * E;
        S[a][b] = S[b][a] = mu * E;
      }
    }
    Lanes square = Lanes::Zero();  // mu E : E
    for (std::size_t a = 0; a < dim; ++a)
      for (std::size_t b = 0; b < dim; ++b) square += S[a][b] * S[a][b];
    energy = 0.5 * lambda * trace * trace + square / (4 * mu);
    for (std::size_t a = 0; a < dim; ++a) S[a][a] += lambda * trace;
  }
};

/// The gradient ahead by the retardation time, H + tau dH/dt (S40). H is linear in the displacement: its
/// change in a sub-step is dt times the gradient of the mean velocity. With dt = 0 the present velocity is
/// used.
template <int dim>
typename HamiltonianBody<dim>::Tensor HamiltonianBody<dim>::later_gradient(const Tensor& H, Eigen::Index i,
                                                                           double dt) {
  if (substance_.retardation == 0) return H;
  const bool starts = dt == 0;
  const double ahead = starts ? substance_.retardation : substance_.retardation / dt;
  Tensor later = starts ? displacement_gradient(velocity_, i) : H;
  for (int a = 0; a < dim; ++a) {
    for (int b = 0; b < dim; ++b) {
      if (!starts) later[a][b] -= at(gradient_[a][b], i);
      later[a][b] = H[a][b] + ahead * later[a][b];
      at(gradient_[a][b], i) = H[a][b];
    }
  }
  return later;
}

/// Sets G of (S33) for a particle with the gradient H and the stress of the gradient `later`.
template <int dim>
void HamiltonianBody<dim>::put_stress(const Tensor& H, const Tensor& later, Eigen::Index i) const {
  const Elasticity& material = substance_.material;
  const double per_mass = 1 / material.density;
  const Stress<dim> stress(later, lambda_, material.mu());
  for (int a = 0; a < dim; ++a) {
    std::array<Lanes, dim> P;
    for (int b = 0; b < dim; ++b) {
      P[b] = stress.S[a][b];
      for (int c = 0; c < dim; ++c) P[b] += H[a][c] * stress.S[c][b];
    }
    for (int b = 0; b < dim; ++b) {
      Lanes G = -0.5 * hold_ * H[a][b];
      for (int c = 0; c < dim; ++c) G += per_mass * P[c] * at(inverse_shape_[c][b], i);
      at(pull_[a][b], i) = G;
    }
  }
}

template <int dim>
void HamiltonianBody<dim>::measure_stress(const Vectors& u) const {
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Tensor H = displacement_gradient(u, i);
    put_stress(H, H, i);
  }
  if (cells_) cells_->measure(u, velocity_, 0);
}

template <int dim>
particles::LaneVec<dim> HamiltonianBody<dim>::internal_acceleration(const Vectors& u, Eigen::Index i) const {
  particles::LaneVec<dim> a;
  if (cells_)
    a = cells_->acceleration(i);
  else
    for (Lanes& component : a) component.setZero();
  for (int k = 0; k < dim; ++k) {
    a[k] -= hold_ * at(weight_, i) * at(u[k], i);
    for (int b = 0; b < dim; ++b) a[k] += at(pull_[k][b], i) * at(first_moment_[b], i);
  }
  for (const Neighbor& n : neighbors_) {
    const Eigen::Index j = i + n.shift;
    for (int k = 0; k < dim; ++k) {
      a[k] += (hold_ * n.w) * at(u[k], j);
      for (int b = 0; b < dim; ++b) a[k] += n.r0[b] * at(pull_[k][b], j);
    }
  }
  return a;
}

template <int dim>
void HamiltonianBody<dim>::advance(int substeps, double dt) {
  for (Slots& increment : this->ramp_increment_) increment.setZero();
  const double left = std::exp(-0.5 * substance_.damping_rate * dt);
  if (!fresh_) accelerate(0, 0);
  for (int k = 0; k < substeps; ++k) {
    const double load_fraction = (k + 0.5) / substeps;
    for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
      for (int c = 0; c < dim; ++c) {
        const Lanes load = at(load_[c], i) + load_fraction * at(load_change_[c], i);
        at(velocity_[c], i) =
            left * at(velocity_[c], i) + 0.5 * dt * at(free_[c], i) * (at(acceleration_[c], i) + load);
      }
      this->drift(i, dt, load_fraction);
    }
    accelerate(dt, load_fraction);
  }
}

/// Adds the second half of a step's impulse; with dt = 0 only the accelerations are computed.
template <int dim>
void HamiltonianBody<dim>::accelerate(double dt, double load_fraction) {
  const double left = std::exp(-0.5 * substance_.damping_rate * dt);
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Tensor H = displacement_gradient(displacement_, i);
    put_stress(H, later_gradient(H, i, dt), i);
  }
  if (cells_) cells_->measure(displacement_, velocity_, substance_.retardation);
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const particles::LaneVec<dim> a = internal_acceleration(displacement_, i);
    for (int c = 0; c < dim; ++c) {
      const Lanes load = at(load_[c], i) + load_fraction * at(load_change_[c], i);
      at(acceleration_[c], i) = a[c];
      at(velocity_[c], i) = left * (at(velocity_[c], i) + 0.5 * dt * at(free_[c], i) * (a[c] + load));
    }
  }
  fresh_ = true;
}

template <int dim>
Energies HamiltonianBody<dim>::energies(double) const {
  const Elasticity& material = substance_.material;
  Lanes kinetic = Lanes::Zero(), elastic = Lanes::Zero(), gravity = Lanes::Zero();
  if (cells_) cells_->measure(displacement_, velocity_, 0);
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const Tensor H = displacement_gradient(displacement_, i);
    Lanes unseen = Lanes::Zero();  // sum of w |d - H r0|^2 of (S32)
    for (const Neighbor& n : neighbors_) {
      const particles::LaneVec<dim> d = Base::difference(displacement_, i, i + n.shift);
      for (int a = 0; a < dim; ++a) {
        Lanes e = d[a];
        for (int b = 0; b < dim; ++b) e -= (n.r0[b] / n.w) * H[a][b];
        unseen += n.w * at(present_, i + n.shift) * e * e;
      }
    }
    elastic += at(present_, i) *
               (Stress<dim>(H, lambda_, material.mu()).energy / material.density + 0.25 * hold_ * unseen);
    if (cells_) elastic += cells_->energy(i);
    for (int k = 0; k < dim; ++k) {
      kinetic += 0.5 * at(velocity_[k], i).square();
      gravity -= substance_.gravity[k] * at(displacement_[k], i);
    }
  }
  return {
      .kinetic = mass_ * kinetic.sum(), .elastic = mass_ * elastic.sum(), .gravity = mass_ * gravity.sum()};
}

template <int dim>
Field HamiltonianBody<dim>::acceleration() const {
  Vectors values;
  values.fill(Slots::Zero(grid_.slots()));
  measure_stress(displacement_);
  for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
    const particles::LaneVec<dim> a = internal_acceleration(displacement_, i);
    for (int k = 0; k < dim; ++k) at(values[k], i) = a[k];
  }
  return this->gather(values);
}

template <int dim>
double HamiltonianBody<dim>::highest_frequency() const {
  std::vector<std::pair<int, Eigen::Index>> unknowns;  // axis, slot
  for (std::size_t p = 0; p < grid_.positions().size(); ++p)
    for (int k = 0; k < dim; ++k)
      if (free_[k][grid_.slot(p)] != 0) unknowns.emplace_back(k, grid_.slot(p));
  Vectors u;
  u.fill(Slots::Zero(grid_.slots()));
  return particles::highest_frequency(unknowns.size(), [&](const Eigen::VectorXd& x) {
    // Strains so small that their squares are negligible.
    const double scale = 1e-7 * stencil_.spacing / x.norm();
    for (std::size_t m = 0; m < unknowns.size(); ++m) u[unknowns[m].first][unknowns[m].second] = scale * x[m];
    measure_stress(u);
    Vectors a = u;
    for (Eigen::Index i = grid_.first_slot(); i < grid_.last_slot(); i += grid_.lanes) {
      const particles::LaneVec<dim> lanes = internal_acceleration(u, i);
      for (int k = 0; k < dim; ++k) at(a[k], i) = lanes[k];
    }
    Eigen::VectorXd y(x.size());
    for (std::size_t m = 0; m < unknowns.size(); ++m)
      y[m] = -a[unknowns[m].first][unknowns[m].second] / scale;
    return y;
  });
}

template <int dim>
void HamiltonianBody<dim>::place(std::size_t particle, const Vec<dim>& displacement,
                                 const Vec<dim>& velocity) {
  Base::place(particle, displacement, velocity);
  fresh_ = false;
}

template <int dim>
void HamiltonianBody<dim>::save(StateWriter& state) const {
  Base::save(state);
  for (const auto& row : gradient_)
    for (const Slots& values : row) state.put(values);
  for (const Slots& values : acceleration_) state.put(values);
  state.put(fresh_);
}

template <int dim>
void HamiltonianBody<dim>::restore(StateReader& state) {
  Base::restore(state);
  for (auto& row : gradient_)
    for (Slots& values : row) state.get(values);
  for (Slots& values : acceleration_) state.get(values);
  state.get(fresh_);
}

template <int dim>
std::unique_ptr<SolidModel> make_hamiltonian(const Structure<dim>& structure,
                                             const HamiltonianParameters& parameters) {
  return particles::make_particle_model<dim>(
      structure, parameters.particles, "solid.hamiltonian",
      [&](const Body<dim>& body, std::size_t number, const particles::Stencil<dim>& stencil,
          const particles::Substance<dim>& substance) {
        return std::make_unique<HamiltonianBody<dim>>(body, number, stencil, substance,
                                                      parameters.stabilisation);
      },
      ". Or the material, st_venant_kirchhoff, has collapsed in compression (solid.model = \"fem\" with "
      "solid.material = \"neo_hookean\")");
}

template class HamiltonianBody<2>;
template class HamiltonianBody<3>;
template std::unique_ptr<SolidModel> make_hamiltonian<2>(const Structure<2>&, const HamiltonianParameters&);
template std::unique_ptr<SolidModel> make_hamiltonian<3>(const Structure<3>&, const HamiltonianParameters&);

}  // namespace cosurge::hamiltonian
