// A body's box as a grid of elements.
#pragma once

#include <vector>

#include "common/lattice.hpp"
#include "common/participant.hpp"
#include "solid_solver/models/fem/quadratic_element.hpp"
#include "solid_solver/supports.hpp"

namespace cosurge::fem {

/// Equal elements of second order fill the body's box. Nodes lie on a grid of half their side, the first axis
/// fastest; those in or on a clamp are held.
template <int dim>
class Mesh {
 public:
  using Element = QuadraticElement<dim>;

  /// A point in an element, by its reference coordinates; beyond [-1, 1] where it lies outside the mesh.
  struct Place {
    Eigen::Index element;
    Vec<dim> xi;
  };

  /// @param longest side of an element [m]; 0 for a third of the box's shortest side
  /// @throws Error for a clamp or support that holds no node, and for more elements than memory holds.
  Mesh(const v1::Body& body, int index, double longest);

  Eigen::Index nodes() const { return position_.cols(); }
  Eigen::Index elements() const { return static_cast<Eigen::Index>(corner_.size()); }
  const Vec<dim>& side() const { return side_; }       ///< of an element [m]
  const Field& position() const { return position_; }  ///< of the nodes [m]
  const Box<dim>& box() const { return box_; }         ///< of the body
  const Axes<dim>& held(Eigen::Index node) const { return held_[static_cast<std::size_t>(node)]; }

  Eigen::Index node(Eigen::Index element, int a) const {
    return corner_[static_cast<std::size_t>(element)] + offset_[static_cast<std::size_t>(a)];
  }

  /// The element that holds x, or the one nearest to it.
  Place place(const Vec<dim>& x) const;

  /// Whether x lies in a clamp and not in the body's box.
  bool only_in_clamp(const Vec<dim>& x) const;

  /// The distance from the box along the axis where it is largest [m]; 0 inside.
  double outside(const Vec<dim>& x) const;

 private:
  using Index = Eigen::Matrix<Eigen::Index, dim, 1>;

  void number_elements();
  void hold(const v1::Body& body, int index);

  Box<dim> box_;
  std::vector<Box<dim>> clamps_;  // widened by rounding
  Index counts_;                  // of elements along each axis
  Vec<dim> side_;
  Field position_;
  std::vector<Axes<dim>> held_;
  std::vector<Eigen::Index> corner_;                      // node 0 of each element
  std::array<Eigen::Index, Element::nodes> offset_ = {};  // from there to node a
};

}  // namespace cosurge::fem
