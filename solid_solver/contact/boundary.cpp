#include "solid_solver/contact/boundary.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "common/geometry/box_facets.hpp"
#include "common/geometry/triangles.hpp"

namespace cosurge::contact {
namespace {

template <int dim>
using Facets = std::vector<typename Shape<dim>::Facet>;

template <int dim>
void turn(typename Shape<dim>::Facet& facet) {
  std::swap(facet[0], facet[1]);
}

/// Volume times dim!, positive if all facets face outwards.
template <int dim>
double signed_volume(const Facets<dim>& facets, const Vec<dim>& origin) {
  double sum = 0;
  for (const auto& facet : facets) {
    Mat<dim> corners;
    for (int k = 0; k < dim; ++k) corners.col(k) = facet[static_cast<std::size_t>(k)] - origin;
    sum += corners.determinant();
  }
  return sum;
}

/// Facets that face outwards, whatever the order of the outline's corners.
template <int dim>
Facets<dim> facing_outwards(const Shape<dim>& shape) {
  if (shape.is_box()) return facets_of(shape.bounds());
  Facets<dim> facets = shape.facets();
  const Box<dim>& box = shape.bounds();
  bool alike = true;
  if constexpr (dim == 3) alike = is_oriented(facets);
  if (alike) {
    if (signed_volume<dim>(facets, box.min) < 0)
      for (auto& facet : facets) turn<dim>(facet);
    return facets;
  }
  const double aside = 1e-6 * (box.max - box.min).norm();
  for (auto& facet : facets) {
    Vec<dim> middle = Vec<dim>::Zero();
    for (const Vec<dim>& corner : facet) middle += corner / dim;
    if (shape.contains(middle + aside * normal_of(facet).normalized())) turn<dim>(facet);
  }
  return facets;
}

/// Numbers for points: the same for the same coordinates.
template <int dim>
class Vertices {
 public:
  int number(const Vec<dim>& x) {
    const auto key = std::vector<double>(x.begin(), x.end());
    const auto [found, is_new] = numbers_.emplace(key, static_cast<int>(all.size()));
    if (is_new) all.push_back(x);
    return found->second;
  }
  std::vector<Vec<dim>> all;

 private:
  std::map<std::vector<double>, int> numbers_;
};

using Sides = std::vector<std::array<int, 2>>;
using Triangles = std::vector<std::array<int, 3>>;

void refine(Vertices<2>& vertices, Sides& sides, double longest) {
  Sides fine;
  for (const auto& [a, b] : sides) {
    const Vec<2> from = vertices.all[static_cast<std::size_t>(a)],
                 to = vertices.all[static_cast<std::size_t>(b)];
    const int parts = std::max(1, static_cast<int>(std::ceil((to - from).norm() / longest - 1e-9)));
    int last = a;
    for (int k = 1; k <= parts; ++k) {
      const int next = k == parts ? b : vertices.number(from + k * (to - from) / parts);
      fine.push_back({last, next});
      last = next;
    }
  }
  sides = std::move(fine);
}

/// One triangle with the middles of its long edges (-1: the edge is short enough), edge k from corner k to
/// the next.
void split(const std::array<int, 3>& corner, const std::array<int, 3>& middle, Triangles& into) {
  const auto count = std::count_if(middle.begin(), middle.end(), [](int m) { return m >= 0; });
  if (count == 0) return into.push_back(corner);
  if (count == 3) {
    for (std::size_t k = 0; k < 3; ++k) into.push_back({corner[k], middle[k], middle[(k + 2) % 3]});
    return into.push_back(middle);
  }
  std::size_t k = 0;  // edge to split; if two edges are split, the first of two consecutive ones
  while (middle[k] < 0 || (count == 2 && middle[(k + 1) % 3] < 0)) ++k;
  const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
  if (count == 1) {
    into.push_back({corner[k], middle[k], corner[m]});
    return into.push_back({middle[k], corner[l], corner[m]});
  }
  into.push_back({middle[k], corner[l], middle[l]});
  into.push_back({corner[k], middle[k], middle[l]});
  into.push_back({corner[k], middle[l], corner[m]});
}

/// Halves long edges until there are none. Both triangles at an edge decide alike whether it is long.
void refine(Vertices<3>& vertices, Triangles& triangles, double longest) {
  const auto middle_of = [&](int a, int b) {
    // Copies, because adding a vertex may move the array.
    const Vec<3> from = vertices.all[static_cast<std::size_t>(std::min(a, b))];
    const Vec<3> to = vertices.all[static_cast<std::size_t>(std::max(a, b))];
    return (to - from).norm() > longest * (1 + 1e-9) ? vertices.number(0.5 * (from + to)) : -1;
  };
  while (true) {
    Triangles fine;
    for (const auto& t : triangles)
      split(t, {middle_of(t[0], t[1]), middle_of(t[1], t[2]), middle_of(t[2], t[0])}, fine);
    const bool done = fine.size() == triangles.size();
    triangles = std::move(fine);
    if (done) return;
  }
}

double area_of(const Field& x, const std::array<int, 2>& side) {
  return (x.col(side[1]) - x.col(side[0])).norm();
}

double area_of(const Field& x, const std::array<int, 3>& t) {
  const Vec<3> a = x.col(t[1]) - x.col(t[0]), b = x.col(t[2]) - x.col(t[0]);
  return 0.5 * a.cross(b).norm();
}

}  // namespace

template <int dim>
Boundary<dim>::Boundary(const Shape<dim>& shape, double longest) {
  Vertices<dim> vertices;
  for (const auto& facet : facing_outwards(shape)) {
    Facet corners;
    for (std::size_t k = 0; k < dim; ++k) corners[k] = vertices.number(facet[k]);
    facets.push_back(corners);
  }
  refine(vertices, facets, longest);
  position.resize(dim, static_cast<Eigen::Index>(vertices.all.size()));
  for (std::size_t v = 0; v < vertices.all.size(); ++v)
    position.col(static_cast<Eigen::Index>(v)) = vertices.all[v];
  area.assign(vertices.all.size(), 0);
  for (const Facet& facet : facets)
    for (const int v : facet) area[static_cast<std::size_t>(v)] += area_of(position, facet) / dim;
  if constexpr (dim == 3) {
    std::map<std::pair<int, int>, int> numbers;
    for (const Facet& f : facets) {
      std::array<int, 3> own;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto ends = std::minmax(f[(k + 1) % 3], f[(k + 2) % 3]);
        own[k] = numbers.emplace(std::pair<int, int>(ends), static_cast<int>(numbers.size())).first->second;
      }
      edges.push_back(own);
    }
    edge_count = static_cast<int>(numbers.size());
  }
}

template struct Boundary<2>;
template struct Boundary<3>;

}  // namespace cosurge::contact
