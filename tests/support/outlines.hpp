// Outlines for the tests.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "common/geometry/body_sites.hpp"
#include "common/participant.hpp"

namespace cosurge::test {

/// Corners of a polygon, or of triangles.
template <int dim>
v1::Shape outline(const std::vector<Vec<dim>>& corners) {
  v1::Shape shape;
  for (const Vec<dim>& corner : corners)
    for (const double value : corner) shape.add_vertex(value);
  return shape;
}

inline v1::Shape box(const std::vector<double>& min, const std::vector<double>& max) {
  v1::Shape shape;
  shape.mutable_min()->Assign(min.begin(), min.end());
  shape.mutable_max()->Assign(max.begin(), max.end());
  return shape;
}

/// A rectangle between two corners, turned about the origin [rad].
inline v1::Shape turned_box(const Vec<2>& min, const Vec<2>& max, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](double x, double y) { return Vec<2>(c * x - s * y, s * x + c * y); };
  return outline<2>({turn(min[0], min[1]), turn(max[0], min[1]), turn(max[0], max[1]), turn(min[0], max[1])});
}

inline v1::Shape disk(const Vec<2>& centre, double radius, int sides = 96) {
  std::vector<Vec<2>> corners;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    corners.push_back(centre + radius * Vec<2>(std::cos(angle), std::sin(angle)));
  }
  return outline<2>(corners);
}

inline double area_of_disk(double radius, int sides = 96) {
  return 0.5 * sides * radius * radius * std::sin(2 * std::numbers::pi / sides);
}

/// The corner of a cube: (0, 0, 0) and the points at `size` on the axes, then moved by `shift`; volume
/// size^3 / 6.
inline v1::Shape tetrahedron(double size, const Vec<3>& shift) {
  const Vec<3>& o = shift;
  const Vec<3> x = o + size * Vec<3>::Unit(0), y = o + size * Vec<3>::Unit(1), z = o + size * Vec<3>::Unit(2);
  return outline<3>({o, y, x, o, x, z, o, z, y, x, y, z});
}

/// A polygon in the plane of x and y, counterclockwise, from z = 0 to `depth`. From its corner `fan` the
/// others are seen.
inline v1::Shape extruded(const std::vector<Vec<2>>& corners, double depth, std::size_t fan = 0) {
  std::vector<Vec<3>> all;
  const auto add = [&](std::size_t k, double z) {
    const Vec<2>& x = corners[k % corners.size()];
    all.emplace_back(x[0], x[1], z);
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    for (const auto& [corner, z] :
         {std::pair(k, 0.0), {k + 1, 0.0}, {k + 1, depth}, {k, 0.0}, {k + 1, depth}, {k, depth}})
      add(corner, z);
    if (k == 0 || k + 1 == corners.size()) continue;
    for (const std::size_t corner : {fan, fan + k + 1, fan + k}) add(corner, 0);
    for (const std::size_t corner : {fan, fan + k, fan + k + 1}) add(corner, depth);
  }
  return outline<3>(all);
}

/// A triangle in the plane of x and y, (0, 0), (width, 0), (0, height), from z = 0 to `depth`.
inline v1::Shape prism(double width, double height, double depth) {
  return extruded({{0, 0}, {width, 0}, {0, height}}, depth);
}

/// Points of a fluid on the sites of a body, with the areas of the faces of cells that nothing covers.
template <int dim>
Interface points_on(const v1::Body& body, double spacing) {
  const BodySites<dim> sites(from_case<dim>(shape_of(body)), spacing);
  const auto count = static_cast<Eigen::Index>(sites.all().size());
  Interface points{
      .dimension = dim, .position = Field(dim, count), .area = Field::Zero(dim, count), .body = {}};
  points.body.assign(sites.all().size(), 0);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vec<dim> x = sites.all()[static_cast<std::size_t>(k)];
    points.position.col(k) = x;
    for (int axis = 0; axis < dim; ++axis)
      for (const double side : {-1.0, 1.0})
        if (!sites.contains(x + side * spacing * Vec<dim>::Unit(axis)))
          points.area(axis, k) += side * std::pow(spacing, dim - 1);
  }
  return points;
}

}  // namespace cosurge::test
