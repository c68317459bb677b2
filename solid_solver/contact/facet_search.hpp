// The point of a boundary that is nearest to another point, and how far inside or outside that one is.
#pragma once

#include <optional>

#include "solid_solver/contact/boundary.hpp"

namespace cosurge::contact {

/// The point of a boundary that is nearest to a given point x.
template <int dim>
struct Nearest {
  double gap;                     ///< distance from the boundary, negative inside [m]
  Vec<dim> normal;                ///< unit normal, outwards: d gap / d x
  int facet;                      ///< facet with the nearest point
  std::array<double, dim> share;  ///< shares of its vertices in the nearest point; their sum is one
};

/// A boundary as it is deformed at one instant, in a grid of cells.
template <int dim>
class FacetSearch {
 public:
  /// @param position of the boundary's vertices now [m], dimension x vertices
  /// @param reach how far away a facet is found [m]
  /// @param region of the query points: facets farther than `reach` from it are left out
  FacetSearch(const Boundary<dim>& boundary, const Eigen::Ref<const Field>& position, double reach,
              const Box<dim>& region);

  /// The nearest point of the boundary; nothing if no facet is within reach. Inside and outside are
  /// determined by the normals of the facets around the nearest point: at edges by their sum, at vertices by
  /// their sum weighted with the angles of the facets (Baerentzen & Aanaes 2005, IEEE Trans. Vis. Comput.
  /// Graph. 11, 243).
  std::optional<Nearest<dim>> nearest(const Vec<dim>& x) const;

 private:
  using Cell = std::array<int, dim>;

  Cell cell_of(const Vec<dim>& x) const;
  template <typename Visit>
  void visit_cells(const Vec<dim>& lower, const Vec<dim>& upper, const Visit& visit) const;
  void sum_normals();
  Vec<dim> normal_at(int facet, const std::array<double, dim>& share) const;
  Vec<dim> vertex(int facet, std::size_t corner) const {
    return position_.col(boundary_->facets[static_cast<std::size_t>(facet)][corner]);
  }

  const Boundary<dim>* boundary_;
  Field position_;
  double reach_;
  std::vector<Vec<dim>> facet_normal_, edge_normal_, vertex_normal_;
  std::vector<Vec<dim>> middle_;              // middle of each facet
  std::vector<double> radius_;                // radius of each facet around its middle
  std::vector<std::pair<Cell, int>> facets_;  // facets of each cell, sorted
};

}  // namespace cosurge::contact
