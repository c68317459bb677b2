// One block of each deformable body with a common interface, for tests that all of them must pass.
#pragma once

#include <cmath>
#include <string>

#include "solid_solver/models/fem/generalised_alpha.hpp"
#include "solid_solver/models/hamiltonian/hamiltonian_body.hpp"
#include "solid_solver/models/mps/mps_body.hpp"
#include "tests/support/solid_cases.hpp"
#include "tests/support/structures.hpp"

namespace cosurge::test {

struct Block {
  int columns = 16;
  int rows = 24;
  bool clamped = false;  ///< at the foot
  double poisson_ratio = 0.3;
  bool plane_stress = false;
  bool neo_hookean = false;
  double viscosity = 0;  ///< viscosity of particles, over rho c_p l0

  Body<2> body() const {
    return body_of<2>(plate({.columns = columns, .rows = rows, .clamped = clamped}).solid().body(0));
  }
  Elasticity material() const {
    return {.density = 2500,
            .young_modulus = 1e6,
            .poisson_ratio = poisson_ratio,
            .plane_stress = plane_stress,
            .neo_hookean = neo_hookean};
  }
  double area() const { return columns * rows * l0 * l0; }
};

/// Displacements, velocities and forces are 2 x nodes; `angle` is the mean rotation of a deformation.
class FemSample {
 public:
  static constexpr double poisson_ratio = 0.3;
  static constexpr double clear_of_faces =
      1e-6;  ///< [m] distance from the faces from which on a node is in the interior
  static constexpr double conserves =
      1e-7;  ///< momenta: the balance of forces is 1e-10 of the largest, 200 times
  static constexpr double rounding = 1e-11;   ///< sum of all forces over the largest force
  static constexpr bool whole_energy = true;  ///< the continuum's energy for affine motion, faces included
  static constexpr bool local = true;         ///< affine motion is in balance clear of faces

  explicit FemSample(const Block& block)
      : body_(block.body(), 0, 0.004, block.material(), Vec<2>::Zero()), motion_(body_, 1, 0) {}

  Field sites() const { return body_.mesh().position(); }
  bool held(Eigen::Index n) const { return body_.mesh().held(n)[0]; }
  void deform(const Field& u, double) { u_ = body_.from_nodes(u); }
  double energy() const { return body_.elastic_energy(u_); }
  Field force() const { return -body_.to_nodes(body_.internal_force(u_).force); }

  void launch(const Field& v) {
    motion_.place(fem::Vector::Zero(body_.unknowns()), body_.from_nodes(v));
    motion_.start(fem::Vector::Zero(body_.unknowns()));
  }
  bool fly() {
    for (int k = 0; k < 200; ++k)
      if (!motion_.step(fem::Vector::Zero(body_.unknowns()), 1e-4).converged) return false;
    return true;
  }
  Vec<3> momenta() const {
    const Field x = sites() + body_.to_nodes(motion_.displacement());
    const Field p = body_.to_nodes(body_.momentum(motion_.velocity()));
    return {p.row(0).sum(), p.row(1).sum(),
            (x.row(0).cwiseProduct(p.row(1)) - x.row(1).cwiseProduct(p.row(0))).sum()};
  }

 private:
  fem::FemBody<2> body_;
  fem::GeneralisedAlpha<2> motion_;
  fem::Vector u_;
};

/// Common code of both bodies of particles.
template <typename Body>
class ParticleSample {
 public:
  static constexpr double poisson_ratio = 0.3;
  static constexpr double clear_of_faces = 5 * l0;  // neighbours of neighbours
  Field sites() const {
    Field X(2, body_.particles());
    for (Eigen::Index p = 0; p < X.cols(); ++p)
      X.col(p) = body_.grid().positions()[static_cast<std::size_t>(p)];
    return X;
  }
  bool held(Eigen::Index n) const { return body_.grid().held(static_cast<std::size_t>(n)); }
  double energy() const { return body_.energies(0).elastic; }
  Field force() const { return body_.particle_mass() * body_.acceleration(); }
  void launch(const Field& v) {
    for (Eigen::Index p = 0; p < v.cols(); ++p)
      body_.place(static_cast<std::size_t>(p), Vec<2>::Zero(), v.col(p));
  }
  bool fly() {
    body_.advance(2000, 0.5 * stable_step_);
    return true;
  }
  /// Sub-steps of the given share of the stable step.
  void advance(int substeps, double share) { body_.advance(substeps, share * stable_step_); }
  Body& body() { return body_; }
  double stable_step() const { return stable_step_; }

 protected:
  ParticleSample(Body body, double stable_step) : body_(std::move(body)), stable_step_(stable_step) {}
  Vec<2> momentum() const { return body_.particle_mass() * body_.velocity().rowwise().sum(); }

  Body body_;
  double stable_step_;
};

inline constexpr double effective_radius = 2.1;

inline particles::Substance<2> substance_of(const Block& block) {
  return {.material = block.material(),
          .gravity = Vec<2>::Zero(),
          .retardation = block.viscosity * l0 / block.material().pressure_speed()};
}

template <MpsParameters::Pairs pairs>
class MpsSample : public ParticleSample<mps::MpsBody<2>> {
 public:
  static constexpr bool whole_energy = false;  // faces of `paper` lack neighbours; large strains: other law
  static constexpr bool local =
      pairs == MpsParameters::Pairs::paper;   // whole weights differ far from the faces too
  static constexpr double conserves = 1e-11;  // rounding of 2000 steps
  static constexpr double rounding = 1e-11;   // sum of all forces over the largest force

  explicit MpsSample(const Block& block)
      : ParticleSample(
            {block.body(), 0, particles::full_stencil<2>(l0, effective_radius), substance_of(block), pairs},
            0) {
    stable_step_ = particles::stable_step(body_.highest_frequency(), substance_of(block).retardation);
  }

  void deform(const Field& u, double angle) {
    for (Eigen::Index p = 0; p < u.cols(); ++p)
      body_.place(static_cast<std::size_t>(p), u.col(p), Axial(angle), Vec<2>::Zero(), Axial(0));
  }
  Vec<3> momenta() const { return {momentum()[0], momentum()[1], body_.angular_momentum()[0]}; }

 private:
  using Axial = mps::MpsBody<2>::Axial;
};

using PaperSample = MpsSample<MpsParameters::Pairs::paper>;
using CorrectedSample = MpsSample<MpsParameters::Pairs::corrected>;

class HamiltonianSample : public ParticleSample<hamiltonian::HamiltonianBody<2>> {
 public:
  static constexpr bool whole_energy = true;
  static constexpr bool local = true;
  // Sums go over displacements, not over their differences: rounding is relative to 24 l0, not to l0.
  static constexpr double conserves = 1e-9;
  static constexpr double rounding = 1e-10;

  explicit HamiltonianSample(const Block& block, double stabilisation = 1)
      : ParticleSample({block.body(), 0, particles::full_stencil<2>(l0, effective_radius),
                        substance_of(block), stabilisation},
                       0) {
    stable_step_ = particles::stable_step(body_.highest_frequency(), substance_of(block).retardation);
  }

  void deform(const Field& u, double) {
    for (Eigen::Index p = 0; p < u.cols(); ++p)
      body_.place(static_cast<std::size_t>(p), u.col(p), Vec<2>::Zero());
  }
  Vec<3> momenta() const {
    const Field x = sites() + body_.displacement(), v = body_.velocity();
    const double turning = (x.row(0).cwiseProduct(v.row(1)) - x.row(1).cwiseProduct(v.row(0))).sum();
    return {momentum()[0], momentum()[1], body_.particle_mass() * turning};
  }
};

/// The same, nearly incompressible.
template <typename Sample>
class Rubber : public Sample {
 public:
  static constexpr double poisson_ratio = 0.49;

  explicit Rubber(const Block& block) : Sample(nearly_incompressible(block)) {}

 private:
  static Block nearly_incompressible(Block block) {
    block.poisson_ratio = poisson_ratio;
    return block;
  }
};

}  // namespace cosurge::test
