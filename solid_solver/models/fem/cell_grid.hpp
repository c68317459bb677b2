// The cells of an even grid that fill a shape.
#pragma once

#include <array>
#include <vector>

#include "common/cell_block.hpp"
#include "common/geometry/shape.hpp"
#include "solid_solver/models/fem/quadratic_element.hpp"

namespace cosurge::fem {

/// An even grid along the shape's own axes (shape_axes.hpp). For a box all cells are kept; for another shape
/// those whose centres it contains. Nodes are those of quadratic elements, vertices and middles, of the kept
/// cells only; they are numbered with the first axis fastest.
template <int dim>
class CellGrid {
 public:
  using Index = typename CellBlock<dim>::Index;  ///< index of a node; even for vertices, odd between
  using Nodes = std::array<Eigen::Index, QuadraticElement<dim>::nodes>;

  /// @param longest side of a cell [m]; 0 for a third of a box's thickness, or of 2 volume / surface
  /// @throws Error where cells are too many or fall apart
  CellGrid(const Shape<dim>& shape, double longest, int body);

  const Vec<dim>& side() const { return side_; }  ///< sides of a cell [m]
  Eigen::Index nodes() const { return static_cast<Eigen::Index>(used_.size()); }

  Index at(Eigen::Index node) const { return grid_.split(used_[static_cast<std::size_t>(node)]); }
  Eigen::Index node(const Index& at) const;  ///< -1 where no cell is kept
  bool vertex(Eigen::Index node) const;
  bool outer(Eigen::Index node) const { return outer_[static_cast<std::size_t>(node)] != 0; }
  Vec<dim> position(Eigen::Index node) const;  ///< in the even grid [m]
  std::vector<Vec<dim>> positions() const;     ///< positions of all nodes

  /// Numbers of the cells around a node: kept ones, and all.
  struct Around {
    int kept = 0, all = 0;
  };
  Around around(const Index& node) const;

  std::vector<Nodes> elements() const;

 private:
  void lay_out(const Shape<dim>& shape, double longest, int body);
  void choose_cells(const Shape<dim>& shape, int body);

  Mat<dim> axes_;
  Vec<dim> origin_, side_;
  CellBlock<dim> cells_, grid_;  // blocks of the cells and of the nodes
  std::vector<char> kept_;
  std::vector<Eigen::Index> used_, number_;  // index in the whole grid of each node, and back
  std::vector<char> outer_;
};

}  // namespace cosurge::fem
