// All bodies of a scene as finite elements: common code of the models on them.
#pragma once

#include <vector>

#include "solid_solver/models/fem/fem_body.hpp"

namespace cosurge::fem {

/// Nodes are those of the meshes, body after body. Frames show the points of the lattice (with the water's
/// spacing) in the bodies, as for the other models.
template <int dim>
class MeshedBodies {
 public:
  /// Vectors over the unknowns, one for each body.
  using Vectors = std::vector<Vector>;

  /// A point may lie half a spacing outside its body.
  /// @throws Error as Mesh does
  explicit MeshedBodies(const Structure<dim>& structure);

  const Elasticity& material() const { return material_; }
  const std::vector<FemBody<dim>>& bodies() const { return bodies_; }
  Eigen::Index nodes() const { return first_.back(); }
  std::uint64_t particles() const { return sites_.size(); }

  /// The elements' shape functions at the points (S24); see SolidModel::interpolation.
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const;

  /// The part of body b of a nodal field, over its unknowns.
  Vector of_body(std::size_t b, const Field& nodal) const;
  Field to_nodes(const Vectors& values) const;

  NodeLayout layout() const;
  Field inertia(const Field& acceleration) const;  ///< M a over all nodes [N]
  Field acceleration_by(const Field& load) const;  ///< M^-1 f at the nodes, zero where they are held [m/s2]

  /// Largest value of all bodies.
  typename FemBody<dim>::Deformation deformation(const Vectors& u) const;
  double max_speed(const Vectors& v) const;

  /// @throws NumericalError for a node that moves faster than the waves of the material, or whose motion is
  /// not finite.
  void check_motion(const Window& window, const Vectors& v) const;

  Snapshot frame(const Vectors& u, const Vectors& v) const;

 private:
  /// A point of the frames.
  struct Site {
    std::size_t body;
    Vec<dim> position;
    typename Mesh<dim>::Place place;
  };

  Elasticity material_;
  double spacing_;
  std::vector<FemBody<dim>> bodies_;
  std::vector<Eigen::Index> first_;  // first node of each body, and the number of nodes
  std::vector<Site> sites_;
};

}  // namespace cosurge::fem
