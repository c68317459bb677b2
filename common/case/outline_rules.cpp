#include "common/case/outline_rules.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "common/error.hpp"
#include "common/geometry/body_sites.hpp"
#include "common/geometry/crossing_sides.hpp"

namespace cosurge {
namespace {

using Corner = std::array<double, 3>;

Corner corner_of(const Shape<3>::Facet& triangle, std::size_t k) {
  return {triangle[k % 3][0], triangle[k % 3][1], triangle[k % 3][2]};
}

std::string open_edge(const std::vector<Shape<3>::Facet>& triangles) {
  std::map<std::pair<Corner, Corner>, int> edges;  // 1: once more in the one sense than in the other
  for (const auto& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner from = corner_of(triangle, k), to = corner_of(triangle, k + 1);
      if (from < to) ++edges[{from, to}];
      if (to < from) --edges[{to, from}];
    }
  }
  for (const auto& [edge, balance] : edges)
    if (balance != 0)
      return fmt::format(
          "the triangles leave a hole, or have opposite orientations, at the edge from ({}) to ({})",
          fmt::join(edge.first, ", "), fmt::join(edge.second, ", "));
  return "";
}

/// Three corners from the smallest on, in the triangle's order around.
std::array<Corner, 3> around(const Shape<3>::Facet& triangle) {
  std::array<Corner, 3> corners = {corner_of(triangle, 0), corner_of(triangle, 1), corner_of(triangle, 2)};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Triangles that are there twice. (In the opposite order around they are the common face of two parts.)
std::string doubled_triangles(const std::vector<Shape<3>::Facet>& triangles) {
  std::map<std::array<Corner, 3>, std::size_t> seen;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::array<Corner, 3> corners = around(triangles[t]);
    const auto [first, is_new] = seen.emplace(corners, t);
    if (!is_new)
      return fmt::format(
          "the triangles {} and {} (counted from 0) have the same corners ({}), ({}), ({}): leave one out",
          first->second, t, fmt::join(corners[0], ", "), fmt::join(corners[1], ", "),
          fmt::join(corners[2], ", "));
  }
  return "";
}

bool has_outline(const v1::Body& body) { return body.shape().vertex_size() > 0; }

/// A site that more than one part of an outline encloses.
template <int dim>
std::optional<Vec<dim>> in_two_parts(const v1::Body& body, const BodySites<dim>& sites) {
  const auto shape = from_case<dim>(shape_of(body));
  for (const Vec<dim>& x : sites.all())
    if (std::abs(shape.winding(x)) > 1) return x;
  return std::nullopt;
}

template <int dim>
void check_sites(const v1::Solid& solid, double spacing, CaseErrors& errors) {
  std::vector<BodySites<dim>> sites;
  for (const v1::Body& body : solid.body()) sites.emplace_back(from_case<dim>(shape_of(body)), spacing);
  for (int i = 0; i < solid.body_size(); ++i) {
    if (!has_outline(solid.body(i))) continue;
    const auto& own = sites[static_cast<std::size_t>(i)];
    const auto add = [&](const std::string& what) { errors.add(body_key(solid, i), what); };
    if (const auto twice = in_two_parts(solid.body(i), own))
      add(fmt::format("has parts that overlap near ({}): join them; otherwise their mass would count twice",
                      fmt::join(*twice, ", ")));
    if (own.all().empty())
      add(fmt::format("encloses no particles with a spacing of {} m", spacing));
    else if (const int parts = own.parts(); parts > 1)
      add(fmt::format("consists of {} separate parts with a spacing of {} m", parts, spacing));
    for (int j = 0; j < solid.body_size(); ++j) {
      if (j == i || (j > i && has_outline(solid.body(j)))) continue;  // seen from the other side
      const auto& other = sites[static_cast<std::size_t>(j)];
      if (std::any_of(own.all().begin(), own.all().end(),
                      [&](const Vec<dim>& x) { return other.contains(x); }))
        add(fmt::format("overlaps {}", body_key(solid, j)));
    }
  }
}

template <int dim>
bool share_sites(const v1::Body& body, const v1::Shape& obstacle, double spacing) {
  const auto shape = from_case<dim>(obstacle);
  const std::vector<Vec<dim>> sites = BodySites<dim>(from_case<dim>(shape_of(body)), spacing).all();
  return std::any_of(sites.begin(), sites.end(), [&](const Vec<dim>& x) { return shape.contains(x); });
}

}  // namespace

std::string body_key(const v1::Solid& solid, int body) {
  return fmt::format("solid.body.{}.{}", body, solid.body(body).has_shape() ? "shape" : "box");
}

std::string too_few_corners(const v1::Shape& outline, int dimension) {
  const int fewest = dimension == 2 ? 3 : 12;  // for a triangle; for the four triangles of a tetrahedron
  const int corners = outline.vertex_size() / dimension;
  return corners < fewest ? fmt::format("the outline has {} corners, needs at least {}", corners, fewest)
                          : "";
}

std::string not_closed(const v1::Shape& outline, int dimension) {
  if (dimension == 2) return crossing_sides(from_case<2>(outline).facets());
  const auto shape = from_case<3>(outline);
  const std::string doubled = doubled_triangles(shape.facets());
  return doubled.empty() ? open_edge(shape.facets()) : doubled;
}

void check_outlined_bodies(const v1::Case& c, CaseErrors& errors) {
  const v1::Solid& solid = c.solid();
  if (std::none_of(solid.body().begin(), solid.body().end(), has_outline)) return;
  std::set<double> spacings;
  if (c.has_fluid()) spacings.insert(c.fluid().spacing());
  if (solid.has_spacing()) spacings.insert(solid.spacing());
  for (const double spacing : spacings) {
    if (c.dimension() == 2)
      check_sites<2>(solid, spacing, errors);
    else
      check_sites<3>(solid, spacing, errors);
  }
}

void check_obstacles(const v1::Case& c, CaseErrors& errors) {
  const v1::Solid& solid = c.solid();
  const double spacing = c.fluid().spacing();
  for (int i = 0; i < solid.body_size(); ++i) {
    for (int j = 0; j < c.fluid().obstacle_size(); ++j) {
      const v1::Shape& obstacle = c.fluid().obstacle(j).shape();
      if (c.dimension() == 2 ? share_sites<2>(solid.body(i), obstacle, spacing)
                             : share_sites<3>(solid.body(i), obstacle, spacing))
        errors.add(body_key(solid, i), fmt::format("overlaps fluid.obstacle.{}.shape", j));
    }
  }
}

}  // namespace cosurge
