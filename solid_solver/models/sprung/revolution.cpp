#include "solid_solver/models/sprung/revolution.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace cosurge::sprung {
namespace {

constexpr double resolved = 0.05;  // [rad] of an oscillation per sub-step: period 2e-4 too long
constexpr int most_substeps = 1000;

/// The matrix of e_axis x.
template <int dim>
Mat<dim> generator_about(int axis) {
  Mat<dim> generator = Mat<dim>::Zero();
  const int from = (axis + 1) % 3, to = (axis + 2) % 3;
  generator(to, from) = 1;
  generator(from, to) = -1;
  return generator;
}

}  // namespace

template <int dim>
Revolution<dim>::Revolution(const Springs& springs, const Mat<dim>& second, double length) : length_(length) {
  if constexpr (dim == 3) {
    if (std::all_of(springs.begin(), springs.end(), [](const auto& spring) { return spring.has_value(); })) {
      space_ = SpaceTurning{.inertia = second.trace() * Mat<3>::Identity() - second};
      for (int k = 0; k < 3; ++k) {
        const Spring& spring = *springs[static_cast<std::size_t>(k)];
        space_->stiffness[k] = spring.stiffness;
        space_->damping[k] = spring.damping;
        space_->preload[k] = spring.preload;
      }
      return;
    }
  }
  for (std::size_t k = 0; k < springs.size(); ++k) {
    if (!springs[k]) continue;
    generator_ = generator_about<dim>(dim == 2 ? 2 : static_cast<int>(k));
    single_ = Turning{.inertia = -(generator_ * second * generator_).trace(),
                      .stiffness = springs[k]->stiffness,
                      .damping = springs[k]->damping,
                      .preload = springs[k]->preload};
  }
}

template <int dim>
Mat<dim> Revolution<dim>::rotation() const {
  if constexpr (dim == 3)
    if (space_) return space_->rotation();
  if (!single_) return Mat<dim>::Identity();
  const double half = std::sin(0.5 * single_->angle);
  return Mat<dim>::Identity() + std::sin(single_->angle) * generator_ +
         2 * half * half * (generator_ * generator_);
}

/// Product of a matrix with the lever arms of the nodes.
template <int dim>
typename Revolution<dim>::Nodal Revolution<dim>::arms(const Mat<dim>& turned) const {
  Nodal moved = Nodal::Zero();
  moved.template rightCols<dim>() = length_ * turned;
  return moved;
}

template <int dim>
int Revolution<dim>::substeps(double window) const {
  double omega = single_ ? std::sqrt(single_->stiffness / single_->inertia) : 0;
  if (space_) {
    const Eigen::SelfAdjointEigenSolver<Mat<3>> principal(space_->inertia);
    omega = std::sqrt(space_->stiffness.maxCoeff() / principal.eigenvalues()[0]) + space_->speed().norm();
  }
  return static_cast<int>(std::clamp(std::ceil(omega * window / resolved), 1.0, 1.0 * most_substeps));
}

template <int dim>
int Revolution<dim>::advance(double window, const Nodal& first, const Nodal& last, const Vec<dim>& arm,
                             const Vec<dim>& weight, Nodal& ramp_increment) {
  if (!is_free()) return 1;
  const int count = substeps(window);
  for (int k = 0; k < count; ++k) {
    const double s = (k + 0.5) / count;
    const Nodal before = displacement();
    step({.nodal = first + s * (last - first), .arm = arm, .weight = weight}, window / count);
    ramp_increment += s * (displacement() - before);
  }
  return count;
}

template <int dim>
void Revolution<dim>::step(const Loads& loads, double dt) {
  Mat<dim> moments = loads.arm * loads.weight.transpose();  // sum of X (x) f
  for (int k = 0; k < dim; ++k) moments.row(k) += length_ * loads.nodal.col(1 + k).transpose();
  if constexpr (dim == 3) {
    if (space_)
      return space_->step(
          [&](const Mat<3>& R) {
            const Mat<3> m = R * moments;
            return Vec<3>(m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0));
          },
          dt);
  }
  single_->step(
      {.across = (generator_ * moments).trace(), .along = -(generator_ * generator_ * moments).trace()}, dt);
}

template <int dim>
typename Revolution<dim>::Nodal Revolution<dim>::velocity() const {
  if constexpr (dim == 3)
    if (space_) return arms(cross_matrix(space_->speed()) * rotation());
  return single_ ? arms(single_->speed * generator_ * rotation()) : Nodal(Nodal::Zero());
}

template <int dim>
double Revolution<dim>::kinetic_energy() const {
  if (space_) return space_->kinetic_energy();
  return single_ ? 0.5 * single_->inertia * single_->speed * single_->speed : 0;
}

template <int dim>
double Revolution<dim>::spring_energy() const {
  if (space_) return space_->spring_energy();
  if (!single_) return 0;
  return 0.5 * single_->stiffness * single_->angle * single_->angle - single_->preload * single_->angle;
}

template <int dim>
NodalMode Revolution<dim>::mode(const Mat<dim>& spin, double inertia, double stiffness) const {
  return {.shape = arms(spin * rotation()), .mass = inertia, .omega_squared = stiffness / inertia};
}

template <int dim>
std::vector<NodalMode> Revolution<dim>::modes() const {
  if constexpr (dim == 3) {
    if (space_) {
      const Eigen::GeneralizedSelfAdjointEigenSolver<Mat<3>> free(Mat<3>(space_->stiffness.asDiagonal()),
                                                                  space_->inertia_in_space());
      std::vector<NodalMode> all;
      for (int k = 0; k < 3; ++k)
        all.push_back(
            mode(cross_matrix(free.eigenvectors().col(k)), 1, std::max(0.0, free.eigenvalues()[k])));
      return all;
    }
  }
  if (!single_) return {};
  return {mode(generator_, single_->inertia, single_->stiffness)};
}

template <int dim>
void Revolution<dim>::save(StateWriter& state) const {
  state.put(single_ ? single_->angle : 0.0);
  state.put(single_ ? single_->speed : 0.0);
  if (!space_) return;
  state.put(Eigen::Vector4d(space_->attitude.coeffs()));
  state.put(space_->momentum);
}

template <int dim>
void Revolution<dim>::restore(StateReader& state) {
  double angle = 0, speed = 0;
  state.get(angle);
  state.get(speed);
  if (single_) {
    single_->angle = angle;
    single_->speed = speed;
  }
  if (!space_) return;
  Eigen::Vector4d attitude;
  state.get(attitude);
  space_->attitude.coeffs() = attitude;
  state.get(space_->momentum);
}

template class Revolution<2>;
template class Revolution<3>;

}  // namespace cosurge::sprung
