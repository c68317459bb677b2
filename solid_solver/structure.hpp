// The structure that a solid model computes.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "common/geometry/motion.hpp"
#include "common/geometry/shape.hpp"
#include "solid_solver/elasticity.hpp"
#include "solid_solver/supports.hpp"

namespace cosurge {

/// One body, with its clamps and supports.
template <int dim>
struct Body {
  Shape<dim> shape;                    ///< undeformed
  std::vector<Shape<dim>> clamps;      ///< regions in which the body is extended and fixed
  std::vector<Support<dim>> supports;  ///< regions in which it is fixed along some axes
  bool held;                           ///< by clamps, supports or springs, or as a fixed rigid body
  Motion<dim> carrier;  ///< motion of what holds the body; its initial velocity if nothing holds it
  Vec<dim> velocity;    ///< initial velocity of the model `sprung` [m/s]
};

/// Parameters of all models of explicit particles.
struct ParticleParameters {
  double re;             ///< effective radius [l0]
  double step_fraction;  ///< sub-step as a share of the stable step
  double substep;        ///< fixed sub-step instead [s]; 0: none
  double viscosity;      ///< viscosity of the material divided by rho c_p l0
};

/// The model `mps`.
struct MpsParameters {
  enum class Pairs {
    corrected,  ///< complete weights at faces, pairs that end at clamps, particles that resist bending
    paper,      ///< the weights of the lattice, too soft at faces (Amaro & Cheng)
  };
  ParticleParameters particles;
  Pairs pairs;
};

/// The model `hamiltonian`.
struct HamiltonianParameters {
  ParticleParameters particles;
  double stabilisation;  ///< modulus of the energy that stabilises the shortest waves, over Young's modulus
};

/// The model `fem`.
struct FemParameters {
  double rho_infinity;  ///< amplitude factor of the fastest oscillations per step
  double substep;       ///< longest sub-step [s]; 0: the window
};

/// The model `modal`.
struct ModalParameters {
  int modes;            ///< number of modes of each body
  double rho_infinity;  ///< amplitude factor of the fastest oscillations per step, as of `fem`
};

/// The model `auto`: modes while they are valid, finite elements otherwise.
struct AutomaticParameters {
  FemParameters fem;
  ModalParameters modal;
};

/// The model `rigid`: fixed bodies.
struct RigidParameters {};

/// A spring and a damper of one free motion.
struct Spring {
  double stiffness;  ///< [N/m], [N m/rad]
  double damping;    ///< [N s/m], [N m s/rad]
  double preload;    ///< force [N] or moment [N m] on the body in its initial position
};

/// The model `sprung`: rigid bodies that move where they have a spring, and are fixed otherwise. Either one
/// or all of the rotations in space have a spring.
template <int dim>
struct SprungParameters {
  std::optional<double> mass;     ///< mass of each body [kg]; otherwise density times volume
  std::optional<Vec<dim>> pivot;  ///< centre of rotation [m]; otherwise the centre of mass of the body
  std::array<std::optional<Spring>, dim> along;              ///< displacements along the axes
  std::array<std::optional<Spring>, dim == 2 ? 1 : 3> turn;  ///< in the plane; in space about x, y and z
};

/// Bodies of one material, and the model that computes them.
template <int dim>
struct Structure {
  using Model = std::variant<MpsParameters, HamiltonianParameters, FemParameters, ModalParameters,
                             AutomaticParameters, RigidParameters, SprungParameters<dim>>;

  Model model;
  double spacing;  ///< spacing of particles, and of the points of frames [m]
  double element;  ///< longest side of a finite element [m]; 0: fem::chosen_grid chooses it
  Elasticity material;
  double damping_ratio;  ///< damping ratio of the first mode of each body
  Vec<dim> gravity;      ///< [m/s2]
  std::vector<Body<dim>> bodies;

  template <typename Parameters>
  bool is() const {
    return std::holds_alternative<Parameters>(model);
  }
};

}  // namespace cosurge
