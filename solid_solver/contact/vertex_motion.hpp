// The vertices of the bodies' boundaries in the unknowns of a model.
#pragma once

#include <vector>

#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge::contact {

/// The matrix H of the vertices (SolidModel::interpolation). A vertex that its model does not reach, such as
/// a spike between particles, follows the nearest vertex that it reaches. Vertices in or on a clamp are held
/// and have an empty matrix row.
/// @param position of the vertices [m], dimension x vertices; `body` of each vertex
template <int dim>
Interpolation vertex_interpolation(const SolidModel& model, const Structure<dim>& structure,
                                   const Field& position, const std::vector<int>& body);

/// Which rows of H are empty.
std::vector<char> empty_rows(const Interpolation& H);

/// For each body: the largest eigenvalue of the acceleration of its vertices by springs with the stiffness
/// `area` on all of them [m^(dim-1)/kg] (docs/method_solid.md, section 12). Found by power iteration from
/// below, to about a tenth.
std::vector<double> fastest_per_stiffness(const SolidModel& model, const Interpolation& H,
                                          const std::vector<double>& area, const std::vector<int>& body,
                                          int bodies, int dimension);

}  // namespace cosurge::contact
