// The faces of obstacles and of the tank, cut into small pieces.
#pragma once

#include <vector>

#include "common/geometry/shape.hpp"

namespace cosurge::fluid {

/// A small piece of a face.
template <int dim>
struct FacePiece {
  Vec<dim> place;  ///< its centre [m]
  Vec<dim> area;   ///< area vector, towards the water [m^(d-1)]
};

/// Pieces of the boundary of a shape, none longer than `longest` [m]. Where closed parts of an outline
/// overlap, parts inside another part are left out.
template <int dim>
std::vector<FacePiece<dim>> pieces_of(const Shape<dim>& shape, double longest);

/// Pieces of the side of a tank that lies across `axis`, at its smaller or larger coordinate (`upper`).
template <int dim>
std::vector<FacePiece<dim>> pieces_of(const Box<dim>& tank, int axis, bool upper, double longest);

}  // namespace cosurge::fluid
