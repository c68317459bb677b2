// Outlines for the tests, and the distances within a layout of wall particles.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "common/geometry/shape.hpp"
#include "fluid_solver/fitted_layout.hpp"

namespace cosurge::fluid::test {

template <int dim>
v1::Shape outline_of(const std::vector<Vec<dim>>& corners) {
  v1::Shape shape;
  for (const Vec<dim>& corner : corners)
    for (const double coordinate : corner) shape.add_vertex(coordinate);
  return shape;
}

/// Corners of the triangles of a box with these corners, outwards.
inline std::vector<Vec<3>> triangles_of_box(const Vec<3>& min, const Vec<3>& max) {
  const auto corner = [&](int k) {
    return Vec<3>((k & 1) != 0 ? max[0] : min[0], (k & 2) != 0 ? max[1] : min[1],
                  (k & 4) != 0 ? max[2] : min[2]);
  };
  std::vector<Vec<3>> corners;
  for (const int k : {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5})
    corners.push_back(corner(k));
  return corners;
}

/// A box around the origin, turned by `angle` in the plane of the first and the last coordinate and, in
/// space, by `second` around the last one.
inline v1::Shape turned_box(const Vec<2>& half, double angle, double = 0) {
  const Eigen::Rotation2Dd turn(angle);
  return outline_of<2>({turn * Vec<2>(-half[0], -half[1]), turn * Vec<2>(half[0], -half[1]),
                        turn * Vec<2>(half[0], half[1]), turn * Vec<2>(-half[0], half[1])});
}

inline v1::Shape turned_box(const Vec<3>& half, double angle, double second = 0) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(second, Vec<3>::UnitZ()) * Eigen::AngleAxisd(-angle, Vec<3>::UnitY()))
          .toRotationMatrix();
  std::vector<Vec<3>> corners = triangles_of_box(-half, half);
  for (Vec<3>& corner : corners) corner = Vec<3>(turn * corner);
  return outline_of<3>(corners);
}

inline v1::Shape circle(double radius, int sides) {
  std::vector<Vec<2>> corners;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline_of<2>(corners);
}

/// A sphere of 2 sides^2 triangles or so, by longitude and latitude.
inline v1::Shape sphere(double radius, int sides) {
  const auto at = [&](int i, int j) {
    const double theta = std::numbers::pi * j / sides, phi = 2 * std::numbers::pi * (i % sides) / sides;
    return Vec<3>(radius *
                  Vec<3>(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
  };
  std::vector<Vec<3>> corners;
  for (int j = 0; j < sides; ++j)
    for (int i = 0; i < sides; ++i) {
      if (j > 0)
        for (const Vec<3>& x : {at(i, j), at(i, j + 1), at(i + 1, j)}) corners.push_back(x);
      if (j + 1 < sides)
        for (const Vec<3>& x : {at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}) corners.push_back(x);
    }
  return outline_of<3>(corners);
}

template <int dim>
std::vector<Vec<dim>> of_kind(const std::vector<WallSite<dim>>& sites, Kind kind) {
  std::vector<Vec<dim>> points;
  for (const auto& site : sites)
    if (site.kind == kind) points.push_back(site.x);
  return points;
}

/// Distance of the nearest of other points, apart from x itself.
template <int dim>
double to_nearest(const Vec<dim>& x, const std::vector<Vec<dim>>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec<dim>& other : points)
    if (other != x) least = std::min(least, (other - x).norm());
  return least;
}

/// The least distance between two particles.
template <int dim>
double least_distance(const std::vector<WallSite<dim>>& sites) {
  std::vector<Vec<dim>> points;
  for (const auto& site : sites) points.push_back(site.x);
  double least = std::numeric_limits<double>::infinity();
  for (const Vec<dim>& x : points) least = std::min(least, to_nearest(x, points));
  return least;
}

}  // namespace cosurge::fluid::test
