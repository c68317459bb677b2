// One body of explicit MPS particles with rotation as an unknown.
#pragma once

#include <memory>
#include <vector>

#include "common/state_bytes.hpp"
#include "solid_solver/models/mps/body_grid.hpp"
#include "solid_solver/models/mps/rotation.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge::mps {

/// Explicit MPS solid (Song et al. 2001; Chikazawa et al. 2001): neighbours and weights of the reference
/// configuration, springs between particles against the frame of the pair's mean rotation, a pressure from
/// the dilatation, and an own rotation of every particle (docs/method_solid.md, S1 to S11). Linear and
/// angular momentum are conserved, and the energy up to the ripple of the symplectic Euler integrator. Arrays
/// go over the slots of a BodyGrid; sums run over the neighbours in ascending order.
template <int dim>
class MpsBody {
 public:
  MpsBody(const v1::Body& body, const Stencil<dim>& stencil, const Elasticity& material,
          const Vec<dim>& gravity);

  const BodyGrid<dim>& grid() const { return grid_; }
  Eigen::Index particles() const { return static_cast<Eigen::Index>(grid_.positions().size()); }
  double particle_mass() const { return mass_; }  ///< [kg], per metre of width in two dimensions

  /// Loads on the particles for the next sub-steps [N], dimension x particles (S14).
  void set_load(const Eigen::Ref<const Field>& first, const Eigen::Ref<const Field>& last);

  /// `substeps` steps of dt [s] by the symplectic Euler scheme (S11).
  void advance(int substeps, double dt);

  /// Moves one free particle: displacement [m], rotation [rad], velocity [m/s], angular velocity [rad/s].
  void place(std::size_t particle, const Vec<dim>& displacement, double rotation, const Vec<dim>& velocity,
             double spin);

  Field displacement() const;    ///< [m] dimension x particles
  Field velocity() const;        ///< [m/s]
  Field ramp_increment() const;  ///< [m] of the last advance (S15)
  Field acceleration()
      const;  ///< [m/s2] by internal forces alone; of held particles too, as if they were free
  double angular_momentum() const;  ///< about the origin, of the particles' motion and their spin [kg m2/s]

  /// Kinetic energy of the velocities at the instant of the displacements, v + dt/2 a (S18).
  Energies energies(double dt) const;

  /// F by weighted least squares over the neighbours [-] (S19); I where neighbours do not span the space.
  Mat<dim> deformation_gradient(std::size_t particle) const;

  void save(StateWriter& state) const;
  void restore(StateReader& state);

 private:
  using Rot = Rotation<dim>;
  using Slots = Eigen::ArrayXd;

  /// What a neighbour does: constants of the pair sums.
  struct Bond {
    Eigen::Index shift;          // to the neighbour's slot
    std::array<double, dim> r0;  // [m]
    double length;               // [m]
    double spring;               // 4 d mu w / (rho n0 r0^2) [1/s2]
    double stretch;              // d w / (n0 r0): dilatation by elongation [1/m]
    double pull;                 // lambda / rho * stretch [m/s2]
  };
  struct Acceleration {
    LaneVec<dim> linear;
    std::array<Lanes, Rot::spins> angular;
    Lanes spring_energy;  // sum of spring |u|^2 over the pairs [m2/s2]
  };

  LaneVec<dim> relative_displacement(Eigen::Index i, Eigen::Index j) const;
  Rot rotation_at(Eigen::Index i) const;
  void measure_dilatation() const;
  Acceleration internal_acceleration(Eigen::Index i) const;
  void accelerate(double dt, double load_fraction);
  void move(double dt, double load_fraction);
  Field gather(const std::array<Slots, dim>& values) const;

  BodyGrid<dim> grid_;
  Stencil<dim> stencil_;
  Elasticity material_;
  Vec<dim> gravity_;
  double mass_;
  bool dilatational_;  // lambda > 0: without it there is no pressure, and no square root in the pair sums
  std::vector<Bond> bonds_;

  Slots present_, free_;  // 1 or 0
  std::array<Slots, dim> displacement_, velocity_, load_, load_change_, ramp_increment_;
  std::array<Slots, Rot::components> rotation_;
  std::array<Slots, Rot::spins> spin_;
  mutable Slots dilatation_;
};

}  // namespace cosurge::mps
