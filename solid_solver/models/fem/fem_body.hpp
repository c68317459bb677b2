// One body of finite elements: its forces, stiffness, mass and energies.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "solid_solver/hyperelasticity.hpp"
#include "solid_solver/models/fem/mesh.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge::fem {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;  ///< the lower triangle of a symmetric one

/// Total Lagrangian finite elements of second order, whose dilatation is linear in each element, so that they
/// do not lock near incompressibility (docs/method_solid.md, S20 to S23, S43). Vectors go over the unknowns:
/// the components of the free nodes' displacement, node after node.
template <int dim>
class FemBody {
 public:
  /// Forces of a displacement, and measures of their validity.
  struct InternalForce {
    Vector force;  ///< [N]
    double gross;  ///< largest component of the force of one element on a node, for the rounding error [N]
    double least_volume;    ///< smallest det F: 0 and less where an element is turned inside out
    Eigen::Index flattest;  ///< element with the least volume
  };

  /// Largest values over the elements' nodes; over their Gauss points where they are fitted to an outline.
  struct Deformation {
    double rotation = 0;  ///< rotation by the antisymmetric displacement gradient [rad], small angles
    double strain = 0;    ///< largest principal value of its symmetric part, either sign [-]
  };

  /// @param index of the body, for messages
  /// @param longest side of an element [m], 0 for a third of the thickness
  FemBody(const Body<dim>& body, std::size_t index, double longest, const Elasticity& material,
          const Vec<dim>& gravity);

  const Mesh<dim>& mesh() const { return mesh_; }
  Eigen::Index unknowns() const { return static_cast<Eigen::Index>(component_.size()); }

  InternalForce internal_force(const Vector& u) const;
  Matrix tangent(const Vector& u) const;            ///< d internal_force / d u [N/m]
  const Matrix& mass() const { return mass_; }      ///< consistent [kg], same pattern as tangent
  const Vector& weight() const { return weight_; }  ///< gravity's force [N]
  double elastic_energy(const Vector& u) const;     ///< [J]
  Vector momentum(const Vector& v) const;           ///< M v
  Field inertia(const Field& acceleration) const;   ///< M a over all nodes, including held ones [N]
  /// Largest diagonal entry of the stiffness of the undeformed body [N/m].
  double largest_stiffness() const { return tangent(Vector::Zero(unknowns())).diagonal().maxCoeff(); }
  Deformation deformation(const Vector& u) const;

  /// Grad u at a point of an element, d u_i / d X_j [-]. In an element that is fitted to an outline it is
  /// evaluated at the nearest point of the region between the Gauss points, because the Jacobian may vanish
  /// at corners.
  Mat<dim> displacement_gradient(const Vector& u, const typename Mesh<dim>::Place& place) const;

  /// Values at the nodes, dimension x nodes, to and from unknowns. Held nodes have no unknowns, and the value
  /// zero.
  Vector from_nodes(const Eigen::Ref<const Field>& values) const;
  Field to_nodes(const Vector& values) const;

 private:
  using Element = QuadraticElement<dim>;
  static constexpr int components = Element::nodes * dim;  // displacement components of an element
  using Nodal = Eigen::Matrix<double, dim, Element::nodes>;
  using Stiffness = Eigen::Matrix<double, components, components>;

  /// One Gauss point. The linear functions of X are orthonormal over the element.
  struct Quadrature {
    typename Element::Gradients gradients;     // by X [1/m]
    double volume;                             // [m^dim]
    Eigen::Matrix<double, dim + 1, 1> linear;  // [m^(-dim/2)]
  };
  using Quadratures = std::array<Quadrature, Element::nodes>;

  /// Values at an element's Gauss points.
  struct Strains {
    std::array<Mat<dim>, Element::nodes> H;
    std::array<double, Element::nodes> dilatation;  // dilatation with the modulus lambda (S43)
  };

  void make_quadratures();
  Strains strains(const Nodal& u, const Quadratures& points) const;
  const Quadratures& quadratures(Eigen::Index element) const {
    return quadratures_[mesh_.even() ? 0 : static_cast<std::size_t>(element)];
  }
  void number_unknowns();
  void make_pattern();
  void integrate_mass(const Vec<dim>& gravity);
  Nodal gather(const Vector& u, Eigen::Index element) const;
  Stiffness element_tangent(const Nodal& u, Eigen::Index element) const;
  void scatter(const Stiffness& part, Eigen::Index element, Matrix& whole) const;

  Elasticity material_;
  bool linear_dilatation_;  // not in plane stress, where the thickness can change
  Mesh<dim> mesh_;
  std::vector<Quadratures> quadratures_;  // one for each element, or a single one if all are alike
  std::vector<Eigen::Index> component_;   // node * dim + axis of each unknown
  std::vector<Eigen::Index> unknown_;     // unknown of each component, -1 if held
  Matrix mass_;
  std::vector<Eigen::Index> slot_;  // index of an element's entry in the matrix, -1: not in the triangle
  Vector weight_;
};

}  // namespace cosurge::fem
