#include "fluid_solver/face_pieces.hpp"

#include "common/geometry/box_facets.hpp"

namespace cosurge::fluid {
namespace {

/// Calls visit(piece) for the equal parts of a side.
template <typename Visit>
void cut(const Facet<2>& side, double longest, Visit&& visit) {
  const Vec<2> way = side[1] - side[0];
  const auto parts = static_cast<int>(std::ceil(way.norm() / longest * (1 - 1e-9)));
  for (int k = 0; k < parts; ++k) {
    const double begin = static_cast<double>(k) / parts, end = static_cast<double>(k + 1) / parts;
    visit(Facet<2>{side[0] + begin * way, side[0] + end * way});
  }
}

/// Halves a triangle across its longest side until no side is too long.
template <typename Visit>
void cut(const Facet<3>& triangle, double longest, Visit&& visit) {
  std::size_t from = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if ((triangle[(k + 1) % 3] - triangle[k]).norm() > (triangle[(from + 1) % 3] - triangle[from]).norm())
      from = k;
  const Vec<3>&a = triangle[from], &b = triangle[(from + 1) % 3], &c = triangle[(from + 2) % 3];
  if ((b - a).norm() <= longest * (1 + 1e-9)) return visit(triangle);
  const Vec<3> middle = 0.5 * (a + b);
  cut(Facet<3>{a, middle, c}, longest, visit);
  cut(Facet<3>{middle, b, c}, longest, visit);
}

/// Centre and area vector of a facet.
template <int dim>
FacePiece<dim> piece(const Facet<dim>& facet) {
  FacePiece<dim> piece{.place = Vec<dim>::Zero(), .area = normal_of(facet) / (dim == 3 ? 2 : 1)};
  for (const Vec<dim>& corner : facet) piece.place += corner / dim;
  return piece;
}

}  // namespace

template <int dim>
std::vector<FacePiece<dim>> pieces_of(const Shape<dim>& shape, double longest) {
  std::vector<FacePiece<dim>> pieces;
  const auto add = [&](const Facet<dim>& facet) { pieces.push_back(piece<dim>(facet)); };
  if (shape.is_box()) {
    for (const Facet<dim>& side : facets_of(shape.bounds())) cut(side, longest, add);
    return pieces;
  }
  const auto add_outer = [&](const Facet<dim>& facet) {
    FacePiece<dim> outer = piece<dim>(facet);
    const double size = outer.area.norm();
    if (size == 0) return;
    const Vec<dim> aside = 1e-3 * longest / size * outer.area;
    const int ahead = shape.winding(outer.place + aside), behind = shape.winding(outer.place - aside);
    if ((ahead == 0) == (behind == 0)) return;       // between two parts, or nothing on either side
    const double shared = std::abs(behind + ahead);  // facets of several parts may lie on each other
    outer.area *= (behind != 0 ? 1 : -1) / shared;
    pieces.push_back(outer);
  };
  for (const Facet<dim>& facet : shape.facets()) cut(facet, longest, add_outer);
  return pieces;
}

template <int dim>
std::vector<FacePiece<dim>> pieces_of(const Box<dim>& tank, int axis, bool upper, double longest) {
  std::vector<FacePiece<dim>> pieces;
  const double side = upper ? tank.max[axis] : tank.min[axis];
  for (const Facet<dim>& facet : facets_of(tank)) {
    const auto beside = [&](const Vec<dim>& corner) { return corner[axis] == side; };
    if (!std::all_of(facet.begin(), facet.end(), beside)) continue;
    cut(facet, longest, [&](const Facet<dim>& small) {
      pieces.push_back(piece<dim>(small));
      pieces.back().area = -pieces.back().area;  // the water is inside
    });
  }
  return pieces;
}

template std::vector<FacePiece<2>> pieces_of(const Shape<2>&, double);
template std::vector<FacePiece<3>> pieces_of(const Shape<3>&, double);
template std::vector<FacePiece<2>> pieces_of(const Box<2>&, int, bool, double);
template std::vector<FacePiece<3>> pieces_of(const Box<3>&, int, bool, double);

}  // namespace cosurge::fluid
