#include "solid_solver/models/fem/cell_grid.hpp"

#include <limits>

#include "common/error.hpp"
#include "solid_solver/models/fem/shape_axes.hpp"
#include "solid_solver/shape_moments.hpp"

namespace cosurge::fem {
namespace {

constexpr double rounding = 1e-6;  // [cell sides] tolerance: 0.0800000001 m has four elements of 0.02 m
constexpr double most_elements = 1e6;

}  // namespace

template <int dim>
CellGrid<dim>::CellGrid(const Shape<dim>& shape, double longest, int body) : axes_(axes_of(shape)) {
  lay_out(shape, longest, body);
  choose_cells(shape, body);
  number_.assign(static_cast<std::size_t>(grid_.cells()), -1);
  for (Eigen::Index n = 0; n < grid_.cells(); ++n) {
    const Around cells = around(grid_.split(n));
    if (cells.kept == 0) continue;
    number_[static_cast<std::size_t>(n)] = nodes();
    used_.push_back(n);
    outer_.push_back(cells.kept < cells.all ? 1 : 0);
  }
}

template <int dim>
void CellGrid<dim>::lay_out(const Shape<dim>& shape, double longest, int body) {
  Vec<dim> low = shape.bounds().min, high = shape.bounds().max;
  double thickness = (high - low).minCoeff();
  if (!shape.is_box()) {
    const ShapeMoments<dim> moments(shape);
    thickness = 2 * moments.volume / moments.surface;
    low.setConstant(std::numeric_limits<double>::infinity());
    high = -low;
    for (const auto& facet : shape.facets()) {
      for (const Vec<dim>& corner : facet) {
        low = low.cwiseMin(axes_.transpose() * corner);
        high = high.cwiseMax(axes_.transpose() * corner);
      }
    }
  }
  if (longest == 0) longest = thickness / 3;
  const Vec<dim> sides = high - low;
  const Vec<dim> counts = ((sides / longest).array().max(rounding) - rounding).ceil().max(1);
  require(counts.prod() <= most_elements,
          "solid.fem.element = {:.3g} m makes {:.3g} elements of solid.body.{}, more than {:.0g}", longest,
          counts.prod(), body, most_elements);
  cells_.count = counts.template cast<Eigen::Index>();
  grid_.count = 2 * cells_.count + Index::Ones();
  side_ = sides.array() / counts.array();
  origin_ = low;
}

template <int dim>
void CellGrid<dim>::choose_cells(const Shape<dim>& shape, int body) {
  kept_.assign(static_cast<std::size_t>(cells_.cells()), 1);
  if (shape.is_box()) return;
  for (Eigen::Index c = 0; c < cells_.cells(); ++c) {
    const Vec<dim> middle =
        origin_ + ((cells_.split(c).template cast<double>().array() + 0.5) * side_.array()).matrix();
    kept_[static_cast<std::size_t>(c)] = shape.contains(axes_ * middle) ? 1 : 0;
  }
  const int pieces = cells_.parts(kept_);
  require(pieces == 1,
          "solid.body.{}: elements of {:.3g} m form {} separate parts; make solid.fem.element shorter", body,
          side_.maxCoeff(), pieces);
}

template <int dim>
typename CellGrid<dim>::Around CellGrid<dim>::around(const Index& node) const {
  Around cells;
  for (int choice = 0; choice < 1 << dim; ++choice) {
    Index cell;
    bool twice = false;  // an odd coordinate has one cell, not two
    for (int axis = 0; axis < dim; ++axis) {
      const bool odd = node[axis] % 2 == 1, lower = (choice >> axis & 1) != 0;
      twice = twice || (odd && lower);
      cell[axis] = node[axis] / 2 - (!odd && lower ? 1 : 0);
    }
    if (twice) continue;
    ++cells.all;
    const Eigen::Index c = cells_.join(cell);
    cells.kept += c >= 0 && kept_[static_cast<std::size_t>(c)] ? 1 : 0;
  }
  return cells;
}

template <int dim>
Eigen::Index CellGrid<dim>::node(const Index& at) const {
  const Eigen::Index n = grid_.join(at);
  return n < 0 ? -1 : number_[static_cast<std::size_t>(n)];
}

template <int dim>
bool CellGrid<dim>::vertex(Eigen::Index node) const {
  const Index k = at(node);
  for (int axis = 0; axis < dim; ++axis)
    if (k[axis] % 2 == 1) return false;
  return true;
}

template <int dim>
Vec<dim> CellGrid<dim>::position(Eigen::Index node) const {
  const Vec<dim> y = origin_ + 0.5 * side_.cwiseProduct(at(node).template cast<double>());
  return axes_.isIdentity(0) ? y : Vec<dim>(axes_ * y);
}

template <int dim>
std::vector<Vec<dim>> CellGrid<dim>::positions() const {
  std::vector<Vec<dim>> all;
  for (Eigen::Index n = 0; n < nodes(); ++n) all.push_back(position(n));
  return all;
}

template <int dim>
std::vector<typename CellGrid<dim>::Nodes> CellGrid<dim>::elements() const {
  std::vector<Nodes> all;
  for (Eigen::Index c = 0; c < cells_.cells(); ++c) {
    if (!kept_[static_cast<std::size_t>(c)]) continue;
    Nodes& nodes = all.emplace_back();
    const Index corner = 2 * cells_.split(c);
    for (int a = 0; a < QuadraticElement<dim>::nodes; ++a)
      nodes[static_cast<std::size_t>(a)] =
          node(corner + QuadraticElement<dim>::place(a).template cast<Eigen::Index>());
  }
  return all;
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace cosurge::fem
