// One body of explicit MPS particles with rotation as an unknown.
#pragma once

#include <optional>
#include <vector>

#include "solid_solver/models/mps/pair_weights.hpp"
#include "solid_solver/models/mps/rotation.hpp"
#include "solid_solver/models/particles/cell_dilatation.hpp"
#include "solid_solver/models/particles/particle_model.hpp"

namespace cosurge::mps {

/// Explicit MPS solid (Song et al. 2001; Chikazawa et al. 2001): neighbours and weights of the reference
/// configuration, springs between particles against the frame of the pair's mean rotation, a pressure from
/// the dilatation, and an own rotation of every particle (docs/method_solid.md, section 1). Linear and
/// angular momentum are conserved, and without viscosity (S40) the energy up to the ripple of the symplectic
/// Euler integrator. Arrays go over the slots of a BodyGrid; sums run over the neighbours in ascending order.
template <int dim>
class MpsBody : public particles::ParticleBody<dim> {
 public:
  /// Components of a rotation.
  using Axial = Eigen::Matrix<double, Rotation<dim>::spins, 1>;

  MpsBody(const Body<dim>& body, std::size_t index, const particles::Stencil<dim>& stencil,
          const particles::Substance<dim>& substance, MpsParameters::Pairs pairs);

  /// Highest angular frequency of the undeformed body, rotations included [rad/s] (S12).
  double highest_frequency() const;

  /// Advances by the symplectic Euler scheme (S11).
  void advance(int substeps, double dt) override;

  /// Kinetic energy of the velocities at the instant of the displacements, v + dt/2 a (S18).
  Energies energies(double dt) const override;

  Field acceleration() const override;

  /// The velocity gets the impulse of a sub-step before the particles move by it.
  double force_instant() const override { return 0; }

  /// Moves one free particle: displacement [m], rotation vector [rad], velocity [m/s], angular velocity
  /// [rad/s].
  void place(std::size_t particle, const Vec<dim>& displacement, const Axial& rotation,
             const Vec<dim>& velocity, const Axial& spin);
  using particles::ParticleBody<dim>::place;

  Axial angular_momentum() const;  ///< about the origin: particles' motion plus spin [kg m2/s]

  void save(StateWriter& state) const override;
  void restore(StateReader& state) override;

 private:
  using Base = particles::ParticleBody<dim>;
  using Rot = Rotation<dim>;
  using Slots = particles::Slots;
  using Base::displacement_, Base::velocity_, Base::load_, Base::load_change_, Base::ramp_increment_;
  using Base::grid_, Base::stencil_, Base::substance_, Base::mass_, Base::present_, Base::free_;

  /// Constants of the pair sums with a neighbour.
  struct Bond {
    Eigen::Index shift;          // to the neighbour's slot
    std::array<double, dim> r0;  // [m]
    double length;               // [m]
    double spring;               // 4 d mu / (rho n0 r0^2), for the weight 1 [1/s2]
    double stretch;              // d / (n0 r0): dilatation by elongation, for the weight 1 [1/m]
    double pull;                 // lambda of particles / rho * stretch [m/s2]
  };
  struct Acceleration {
    LaneVec<dim> linear;
    std::array<Lanes, Rot::spins> angular;
    Lanes spring_energy;  // twice the energy of the particle's pairs over its mass [m2/s2]
  };

  using Displacements = std::array<Slots, dim>;
  using Rotations = std::array<Slots, Rot::components>;

  /// Pose for which strains are measured: the present pose, or the pose extrapolated by the retardation time
  /// (S40).
  struct Pose {
    const Displacements& displacement;
    const Rotations& rotation;
    Rot rotation_at(Eigen::Index i) const;
  };

  Pose present() const { return {displacement_, rotation_}; }
  Pose look_ahead();
  void measure_dilatation(const Pose& strained) const;
  void measure_at_rest() const;  // without the velocity terms of the strains
  Acceleration internal_acceleration(const Pose& strained, Eigen::Index i) const;
  void accelerate(const Pose& strained, double dt, double load_fraction);
  void move(double dt, double load_fraction);

  PairWeights<dim> weights_;
  bool dilatational_;  // lambda > 0; otherwise pair sums need neither pressures nor square roots
  std::vector<Bond> bonds_;
  Slots turns_;  // 1 or 0: whether the particle may rotate
  Rotations rotation_;
  Displacements later_displacement_;  // displacement ahead by the retardation time
  Rotations later_rotation_;
  std::array<Slots, Rot::spins> spin_;
  mutable Slots dilatation_;
  std::optional<particles::CellDilatation<dim>> cells_;  // where Poisson's ratio is near 1/2 (S42)
};

/// The model `mps` of a structure.
/// @throws Error for a body without free particles or thinner than two, and for a sub-step beyond the stable
/// one.
template <int dim>
std::unique_ptr<SolidModel> make_mps(const Structure<dim>& structure, const MpsParameters& parameters);

}  // namespace cosurge::mps
