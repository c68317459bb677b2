// The elements of a body.
#pragma once

#include <vector>

#include "solid_solver/models/fem/element_bins.hpp"
#include "solid_solver/models/fem/fitted_grid.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge::fem {

/// A grid of elements of second order in the body's shape (FittedGrid); nodes in or on a clamp are held.
template <int dim>
class Mesh {
 public:
  using Element = QuadraticElement<dim>;

  /// A point in an element, by its reference coordinates; beyond [-1, 1] where it lies outside the mesh.
  struct Place {
    Eigen::Index element;
    Vec<dim> xi;
  };

  /// @param longest side of an element [m]; 0: chosen_grid chooses it
  /// @throws Error as FittedGrid does, and for a clamp or support that holds no node.
  Mesh(const Body<dim>& body, std::size_t index, double longest);

  Eigen::Index nodes() const { return grid_.position.cols(); }
  Eigen::Index elements() const { return static_cast<Eigen::Index>(grid_.node.size()); }
  bool even() const { return shape_.is_box(); }             ///< all elements are the same box
  const Vec<dim>& side() const { return grid_.side; }       ///< sides of an element before fitting [m]
  const Field& position() const { return grid_.position; }  ///< positions of the nodes [m]
  const Shape<dim>& shape() const { return shape_; }        ///< shape of the body
  const Axes<dim>& held(Eigen::Index node) const { return held_[static_cast<std::size_t>(node)]; }

  Eigen::Index node(Eigen::Index element, int a) const {
    return grid_.node[static_cast<std::size_t>(element)][static_cast<std::size_t>(a)];
  }

  /// The nodes' positions of an element.
  Eigen::Matrix<double, dim, Element::nodes> corners(Eigen::Index element) const;

  /// The element that contains x, or the nearest one, with sum N_a(xi) X_a = x.
  /// @throws NumericalError where there is none.
  Place place(const Vec<dim>& x) const;

  /// Whether x lies in a clamp and not in the body's shape.
  bool only_in_clamp(const Vec<dim>& x) const;

  /// Distance of x from the shape along the axis where this is largest [m]; 0 inside.
  double outside(const Vec<dim>& x) const { return shape_.outside(x); }

 private:
  void hold(const Body<dim>& body, std::size_t index);
  Place place_in_grid(const Vec<dim>& x) const;

  Shape<dim> shape_;
  FittedGrid<dim> grid_;
  double margin_;               // tolerance for rounding [m]
  std::vector<Box<dim>> near_;  // box of each fitted element, for the point search
  ElementBins<dim> bins_;       // bins of these boxes
  std::vector<Shape<dim>> clamps_;
  std::vector<Axes<dim>> held_;
};

}  // namespace cosurge::fem
