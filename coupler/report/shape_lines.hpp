// Shapes and boxes as lines.
#pragma once

#include <nlohmann/json.hpp>

#include "common/geometry/shape.hpp"

namespace cosurge {

/// One line through points, as the page of a report has them.
template <int dim>
using Polyline = std::vector<Vec<dim>>;

/// The edges of a box.
std::vector<Polyline<2>> edges_of(const Box<2>& box);
std::vector<Polyline<3>> edges_of(const Box<3>& box);

/// The sides of a polygon, in one line; of triangles the edges where the surface bends, or ends.
std::vector<Polyline<2>> edges_of(const Shape<2>& shape);
std::vector<Polyline<3>> edges_of(const Shape<3>& shape);

/// Floor and side walls of a tank that is open at its top, the last coordinate.
std::vector<Polyline<2>> tank_edges(const Box<2>& tank);
std::vector<Polyline<3>> tank_edges(const Box<3>& tank);

/// Sides of cells of the lattice between those that hold one of the sites and those that do not.
std::vector<Polyline<2>> stairs_of(const std::vector<Vec<2>>& sites, double spacing);

/// [[[x, y], [x, y]], ...]
template <int dim>
nlohmann::ordered_json json_of(const std::vector<Polyline<dim>>& lines) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Polyline<dim>& line : lines) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const Vec<dim>& x : line) points.push_back(std::vector<double>(x.data(), x.data() + dim));
    out.push_back(std::move(points));
  }
  return out;
}

}  // namespace cosurge
