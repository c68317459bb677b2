// The vertices of the bodies' boundaries in the unknowns of a model.
#pragma once

#include <vector>

#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge::contact {

/// H of the vertices (SolidModel::interpolation). One that its model does not reach, at a spike between its
/// particles, follows the nearest one that it does. Those in or on a clamp have an empty row: they are held.
/// @param position of the vertices [m], dimension x vertices; `body` of each
template <int dim>
Interpolation vertex_interpolation(const SolidModel& model, const Structure<dim>& structure,
                                   const Field& position, const std::vector<int>& body);

/// Which rows of H are empty.
std::vector<char> empty_rows(const Interpolation& H);

/// For each body: largest eigenvalue of the vertices' accelerations by springs of stiffness `area` on all its
/// vertices [m^(dim-1)/kg]. Power iteration from below, exact to about a tenth.
std::vector<double> fastest_per_stiffness(const SolidModel& model, const Interpolation& H,
                                          const std::vector<double>& area, const std::vector<int>& body,
                                          int bodies, int dimension);

}  // namespace cosurge::contact
