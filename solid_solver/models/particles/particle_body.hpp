// Common code of all bodies of particles: lattice, motion and loads.
#pragma once

#include <vector>

#include "common/state_bytes.hpp"
#include "solid_solver/elasticity.hpp"
#include "solid_solver/models/particles/body_grid.hpp"
#include "solid_solver/models/particles/lanes.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge::particles {

/// Properties of a body of particles that do not depend on the law of forces.
template <int dim>
struct Substance {
  Elasticity material;
  Vec<dim> gravity;         ///< [m/s2]
  double damping_rate = 0;  ///< damping rate of all velocities [1/s]: v' = ... - rate v
  double retardation = 0;   ///< tau of Kelvin and Voigt's stress, S(E + tau dE/dt) [s] (S40)
};

/// Particles on the slots of a BodyGrid, moved by explicit sub-steps; the derived class computes their
/// forces.
template <int dim>
class ParticleBody {
 public:
  ParticleBody(const Body<dim>& body, std::size_t index, const Stencil<dim>& stencil,
               const Substance<dim>& substance);
  virtual ~ParticleBody() = default;

  const BodyGrid<dim>& grid() const { return grid_; }
  Eigen::Index particles() const { return static_cast<Eigen::Index>(grid_.positions().size()); }
  double particle_mass() const { return mass_; }  ///< [kg], per metre of width in two dimensions

  /// Loads on the particles for the next sub-steps [N], dimension x particles (S14).
  void set_load(const Eigen::Ref<const Field>& first, const Eigen::Ref<const Field>& last);

  /// Sub-steps of dt [s].
  virtual void advance(int substeps, double dt) = 0;

  /// @param dt of the last sub-step [s]
  virtual Energies energies(double dt) const = 0;

  /// Acceleration by internal forces alone [m/s2]; held particles as if they were free.
  virtual Field acceleration() const = 0;

  /// Acceleration by loads on the particles [N] alone [m/s2]; zero for held particles.
  Field acceleration_by(const Eigen::Ref<const Field>& load) const;

  /// See SolidModel::force_instant.
  virtual double force_instant() const = 0;

  Field displacement() const { return gather(displacement_); }      ///< [m] dimension x particles
  Field velocity() const { return gather(velocity_); }              ///< [m/s]
  Field ramp_increment() const { return gather(ramp_increment_); }  ///< [m] of the last advance (S15)

  /// F by weighted least squares over the neighbours [-] (S19); I where neighbours do not span the space.
  Mat<dim> deformation_gradient(std::size_t particle) const;

  /// Moves one particle, where it is free: displacement [m], velocity [m/s].
  virtual void place(std::size_t particle, const Vec<dim>& displacement, const Vec<dim>& velocity);

  virtual void save(StateWriter& state) const;
  virtual void restore(StateReader& state);

 protected:
  /// Value of slot j minus value of slot i.
  static LaneVec<dim> difference(const std::array<Slots, dim>& values, Eigen::Index i, Eigen::Index j);
  Field gather(const std::array<Slots, dim>& values) const;

  /// u += dt v, and the ramp's share of it.
  void drift(Eigen::Index i, double dt, double load_fraction);

  BodyGrid<dim> grid_;
  Stencil<dim> stencil_;
  Substance<dim> substance_;
  double mass_;
  Slots present_;                // 1 or 0
  std::array<Slots, dim> free_;  // 1 or 0
  std::array<Slots, dim> displacement_, velocity_, ramp_increment_;
  std::array<Slots, dim> load_, load_change_;  // over the mass, gravity included [m/s2]
};

}  // namespace cosurge::particles
