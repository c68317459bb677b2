// One body of particles whose forces derive from one energy.
#pragma once

#include <optional>
#include <vector>

#include "solid_solver/models/particles/cell_dilatation.hpp"
#include "solid_solver/models/particles/particle_model.hpp"

namespace cosurge::hamiltonian {

/// Total Lagrangian particles (Kondo et al. 2010; docs/method_solid.md, section 9): deformation gradients by
/// weighted least squares over the reference neighbours, St. Venant-Kirchhoff material, and a stabilising
/// energy for deformation that does not change these gradients (S32). Forces are the exact derivative of the
/// total energy, so that energy, linear and angular momentum are conserved; viscosity (S40) only reduces the
/// energy. Time integration is velocity Verlet. Sums run over the neighbours in ascending order, for eight
/// particles at a time.
template <int dim>
class HamiltonianBody : public particles::ParticleBody<dim> {
 public:
  /// @param stabilisation modulus kappa of the stabilising energy, over Young's modulus [-]
  HamiltonianBody(const Body<dim>& body, std::size_t index, const particles::Stencil<dim>& stencil,
                  const particles::Substance<dim>& substance, double stabilisation);

  /// Highest angular frequency of the undeformed body [rad/s], by Lanczos iteration: steps are stable up to 2
  /// over it.
  double highest_frequency() const;

  void advance(int substeps, double dt) override;
  Energies energies(double dt) const override;
  Field acceleration() const override;

  double force_instant() const override { return 0.5; }
  void place(std::size_t particle, const Vec<dim>& displacement, const Vec<dim>& velocity) override;
  void save(StateWriter& state) const override;
  void restore(StateReader& state) override;

 private:
  using Base = particles::ParticleBody<dim>;
  using Slots = particles::Slots;
  using Lanes = particles::Lanes;
  using Base::displacement_, Base::velocity_, Base::load_, Base::load_change_;
  using Base::grid_, Base::stencil_, Base::substance_, Base::mass_, Base::present_, Base::free_;
  using Tensor = std::array<std::array<Lanes, dim>, dim>;
  using Tensors = std::array<std::array<Slots, dim>, dim>;
  using Vectors = std::array<Slots, dim>;

  struct Neighbor {
    Eigen::Index shift;          // to its slot
    double w;                    // weight
    std::array<double, dim> r0;  // w times the way to it [m]
  };

  void sum_geometry();
  Tensor displacement_gradient(const Vectors& u, Eigen::Index i) const;
  Tensor later_gradient(const Tensor& H, Eigen::Index i, double dt);
  void put_stress(const Tensor& H, const Tensor& later, Eigen::Index i) const;
  void measure_stress(const Vectors& u) const;
  particles::LaneVec<dim> internal_acceleration(const Vectors& u, Eigen::Index i) const;
  void accelerate(double dt, double load_fraction);

  std::vector<Neighbor> neighbors_;
  double hold_;            // 2 kappa c0 / rho [1/(m2 s2)], pair constant of the second energy (S33)
  Slots weight_;           // sum of w over the neighbours that are there
  Vectors first_moment_;   // sum of w r0 over them [m]: zero in the interior
  Tensors inverse_shape_;  // A^-1 [1/m2]
  mutable Tensors pull_;   // G = (P A^-1 - kappa c0 H) / rho
  Tensors gradient_;       // H of the previous sub-step
  Vectors acceleration_;   // by internal forces, with the velocity half a step before (S41)
  bool fresh_ = false;     // whether acceleration_ belongs to the present state
  double lambda_;          // part of lambda that acts on particles [Pa]
  std::optional<particles::CellDilatation<dim>> cells_;  // where Poisson's ratio is near 1/2 (S42)
};

/// The model `hamiltonian` of a structure.
/// @throws Error for a body without free particles or thinner than two, and for a sub-step beyond the stable
/// one.
template <int dim>
std::unique_ptr<SolidModel> make_hamiltonian(const Structure<dim>& structure,
                                             const HamiltonianParameters& parameters);

}  // namespace cosurge::hamiltonian
