#include "solid_solver/models/fem/fitted_grid.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "common/error.hpp"
#include "solid_solver/models/fem/outline_corners.hpp"
#include "solid_solver/shape_moments.hpp"

namespace cosurge::fem {
namespace {

constexpr double rounding = 1e-6;  // of a side: 0.0800000001 m of elements of 0.02 m are four
constexpr double most_elements = 1e6;
constexpr int sweeps = 30;          // of the smoothing: moves go about as many cells far as they are rows
constexpr double most_bent = 0.2;   // of an edge: how far its middle may be off
constexpr double flattest = 0.002;  // least determinant of an element's Jacobian, over the even cell's
constexpr double most_lost = 0.02;  // of the volume
constexpr int most_halvings = 12;   // of the way of a vertex
constexpr double alike = 1e-3;      // principal moments that differ by less have no axes

template <int dim>
using Index = Eigen::Matrix<Eigen::Index, dim, 1>;

/// Axes of the grid: those of the shape's moments in the order of the coordinates they are closest to.
template <int dim>
Mat<dim> principal_axes(const Mat<dim>& second) {
  const Eigen::SelfAdjointEigenSolver<Mat<dim>> solver(second);
  const Vec<dim> values = solver.eigenvalues();
  for (int k = 0; k + 1 < dim; ++k)
    if (values[k + 1] - values[k] < alike * values[dim - 1]) return Mat<dim>::Identity();
  Mat<dim> axes = Mat<dim>::Zero(), left = solver.eigenvectors();
  for (int k = 0; k < dim; ++k) {
    Eigen::Index nearest = 0;
    left.row(k).cwiseAbs().maxCoeff(&nearest);
    axes.col(k) = left.col(nearest) * (left(k, nearest) < 0 ? -1 : 1);
    left.col(nearest).setZero();
  }
  return axes.determinant() > 0 ? axes : Mat<dim>::Identity();
}

template <int dim>
bool is_vertex(const Index<dim>& node) {
  for (int k = 0; k < dim; ++k)
    if (node[k] % 2 == 1) return false;
  return true;
}

/// Of an element, by its Gauss points.
struct Quality {
  double least_jacobian = std::numeric_limits<double>::infinity();  // determinant
  double volume = 0;
};

template <int dim>
Quality quality_of(const Eigen::Matrix<double, dim, QuadraticElement<dim>::nodes>& corners) {
  Quality quality;
  for (const auto& sample : QuadraticElement<dim>::gauss()) {
    const double determinant = (corners * QuadraticElement<dim>::gradients(sample.xi)).determinant();
    quality.least_jacobian = std::min(quality.least_jacobian, determinant);
    quality.volume += sample.weight * determinant;
  }
  return quality;
}

/// The grid of cells and, with twice as many intervals, of nodes.
template <int dim>
class Fitting {
 public:
  Fitting(const Shape<dim>& shape, double longest, int body) : shape_(shape), body_(body) {
    lay_out(longest);
    choose_cells();
    number_nodes();
    if (shape_.is_box()) return;
    fit();
  }

  const Vec<dim>& side() const { return side_; }

  Field positions() const {
    Field position(dim, static_cast<Eigen::Index>(used_.size()));
    for (std::size_t n = 0; n < used_.size(); ++n)
      position.col(static_cast<Eigen::Index>(n)) = x_[static_cast<std::size_t>(used_[n])];
    return position;
  }

  std::vector<std::array<Eigen::Index, QuadraticElement<dim>::nodes>> elements() const {
    std::vector<std::array<Eigen::Index, QuadraticElement<dim>::nodes>> all;
    for (Eigen::Index c = 0; c < cells_.prod(); ++c) {
      if (!kept_[static_cast<std::size_t>(c)]) continue;
      auto& nodes = all.emplace_back();
      const Index<dim> corner = 2 * split(c, cells_);
      for (int a = 0; a < QuadraticElement<dim>::nodes; ++a) {
        const Index<dim> at = corner + QuadraticElement<dim>::place(a).template cast<Eigen::Index>();
        nodes[static_cast<std::size_t>(a)] = number_[static_cast<std::size_t>(join(at, grid_))];
      }
    }
    return all;
  }

 private:
  static Eigen::Index join(const Index<dim>& k, const Index<dim>& counts) {
    if ((k.array() < 0).any() || (k.array() >= counts.array()).any()) return -1;
    Eigen::Index all = 0;
    for (int axis = dim - 1; axis >= 0; --axis) all = all * counts[axis] + k[axis];
    return all;
  }
  static Index<dim> split(Eigen::Index all, const Index<dim>& counts) {
    Index<dim> k;
    for (int axis = 0; axis < dim; all /= counts[axis], ++axis) k[axis] = all % counts[axis];
    return k;
  }

  void lay_out(double longest);
  void choose_cells();
  void number_nodes();
  int kept_around(const Index<dim>& node, int* all) const;
  void fit();
  void pin_corners();
  void smooth();
  void place_middles(int odd);
  bool loosen();
  Vec<dim> even(Eigen::Index node) const {
    const Vec<dim> y = origin_ + 0.5 * side_.cwiseProduct(split(node, grid_).template cast<double>());
    return shape_.is_box() ? y : Vec<dim>(axes_ * y);
  }

  const Shape<dim>& shape_;
  int body_;
  Mat<dim> axes_ = Mat<dim>::Identity();
  Vec<dim> origin_, side_;
  Index<dim> cells_, grid_;  // number along each axis
  std::vector<char> kept_;
  std::vector<Eigen::Index> used_, number_;  // nodes of the grid, and back
  std::vector<char> outer_;                  // of all nodes of the grid
  std::vector<Vec<dim>> x_;                  // of these
  std::vector<Eigen::Index> pinned_;
  std::vector<char> loose_;  // vertices that are not where they would fit
};

template <int dim>
void Fitting<dim>::lay_out(double longest) {
  Vec<dim> low = shape_.bounds().min, high = shape_.bounds().max;
  double thickness = (high - low).minCoeff();
  if (!shape_.is_box()) {
    const ShapeMoments<dim> moments(shape_);
    axes_ = principal_axes<dim>(moments.second);
    thickness = 2 * moments.volume / moments.surface;
    low.setConstant(std::numeric_limits<double>::infinity());
    high = -low;
    for (const auto& facet : shape_.facets()) {
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
          counts.prod(), body_, most_elements);
  cells_ = counts.template cast<Eigen::Index>();
  grid_ = 2 * cells_ + Index<dim>::Ones();
  side_ = sides.array() / counts.array();
  origin_ = low;
}

template <int dim>
void Fitting<dim>::choose_cells() {
  kept_.assign(static_cast<std::size_t>(cells_.prod()), 1);
  if (shape_.is_box()) return;
  for (Eigen::Index c = 0; c < cells_.prod(); ++c) {
    const Vec<dim> middle =
        origin_ + ((split(c, cells_).template cast<double>().array() + 0.5) * side_.array()).matrix();
    kept_[static_cast<std::size_t>(c)] = shape_.contains(axes_ * middle) ? 1 : 0;
  }
  std::vector<char> left = kept_;
  int parts = 0;
  for (Eigen::Index start = 0; start < cells_.prod(); ++start) {
    if (!left[static_cast<std::size_t>(start)]) continue;
    ++parts;
    std::vector<Eigen::Index> open = {start};
    left[static_cast<std::size_t>(start)] = 0;
    while (!open.empty()) {
      const Index<dim> k = split(open.back(), cells_);
      open.pop_back();
      for (int way = 0; way < 2 * dim; ++way) {
        const Eigen::Index next = join(k + (way % 2 * 2 - 1) * Index<dim>::Unit(way / 2), cells_);
        if (next < 0 || !left[static_cast<std::size_t>(next)]) continue;
        left[static_cast<std::size_t>(next)] = 0;
        open.push_back(next);
      }
    }
  }
  require(parts == 1,
          "solid.body.{}: elements of {:.3g} m fall into {} parts; make solid.fem.element shorter", body_,
          side_.maxCoeff(), parts);
}

/// Cells around a node that are kept, and of how many.
template <int dim>
int Fitting<dim>::kept_around(const Index<dim>& node, int* all) const {
  int kept = 0;
  *all = 0;
  for (int choice = 0; choice < 1 << dim; ++choice) {
    Index<dim> cell;
    bool twice = false;  // an odd coordinate has one cell, not two
    for (int axis = 0; axis < dim; ++axis) {
      const bool odd = node[axis] % 2 == 1, lower = (choice >> axis & 1) != 0;
      twice = twice || (odd && lower);
      cell[axis] = node[axis] / 2 - (!odd && lower ? 1 : 0);
    }
    if (twice) continue;
    ++*all;
    const Eigen::Index c = join(cell, cells_);
    kept += c >= 0 && kept_[static_cast<std::size_t>(c)] ? 1 : 0;
  }
  return kept;
}

template <int dim>
void Fitting<dim>::number_nodes() {
  const auto total = static_cast<std::size_t>(grid_.prod());
  number_.assign(total, -1);
  outer_.assign(total, 0);
  x_.resize(total);
  for (std::size_t n = 0; n < total; ++n) {
    const Index<dim> at = split(static_cast<Eigen::Index>(n), grid_);
    int all = 0;
    const int kept = kept_around(at, &all);
    if (kept == 0) continue;
    number_[n] = static_cast<Eigen::Index>(used_.size());
    used_.push_back(static_cast<Eigen::Index>(n));
    outer_[n] = kept < all ? 1 : 0;
    x_[n] = even(static_cast<Eigen::Index>(n));
  }
}

template <int dim>
void Fitting<dim>::fit() {
  pin_corners();
  smooth();
  loose_.assign(x_.size(), 0);
  for (int halving = 0; halving < most_halvings; ++halving) {
    for (int odd = 1; odd <= dim; ++odd) place_middles(odd);
    if (!loosen()) return;
  }
}

/// Vertices of elements that are too flat go half the way back to the even grid. Whether there were any.
template <int dim>
bool Fitting<dim>::loosen() {
  std::vector<char> flat(x_.size(), 0);
  const auto elements_now = elements();
  const Field position = positions();
  for (const auto& nodes : elements_now) {
    Eigen::Matrix<double, dim, QuadraticElement<dim>::nodes> corners;
    for (int a = 0; a < corners.cols(); ++a)
      corners.col(a) = position.col(nodes[static_cast<std::size_t>(a)]);
    if (quality_of<dim>(corners).least_jacobian > flattest * side_.prod() / (1 << dim)) continue;
    for (const Eigen::Index node : nodes)
      flat[static_cast<std::size_t>(used_[static_cast<std::size_t>(node)])] = 1;
  }
  bool any = false;
  for (const Eigen::Index n : used_) {
    const auto at = static_cast<std::size_t>(n);
    if (!flat[at] || !is_vertex<dim>(split(n, grid_))) continue;
    x_[at] = 0.5 * (x_[at] + even(n));
    loose_[at] = 1;
    any = true;
  }
  return any;
}

/// The nearest outer vertex of the grid goes to each corner of the outline.
template <int dim>
void Fitting<dim>::pin_corners() {
  for (const Vec<dim>& corner : corners_of(shape_)) {
    Eigen::Index nearest = -1;
    for (const Eigen::Index n : used_) {
      const auto at = static_cast<std::size_t>(n);
      if (!outer_[at] || !is_vertex<dim>(split(n, grid_))) continue;
      if (std::find(pinned_.begin(), pinned_.end(), n) != pinned_.end()) continue;
      if (nearest < 0 || (x_[at] - corner).norm() < (x_[static_cast<std::size_t>(nearest)] - corner).norm())
        nearest = n;
    }
    if (nearest < 0) return;
    x_[static_cast<std::size_t>(nearest)] = corner;
    pinned_.push_back(nearest);
  }
}

/// Vertices go to the mean of those that an edge of an element joins them to: outer ones along the outline.
template <int dim>
void Fitting<dim>::smooth() {
  std::vector<std::pair<std::size_t, std::vector<std::size_t>>> moves;
  for (const Eigen::Index n : used_) {
    const Index<dim> at = split(n, grid_);
    if (!is_vertex<dim>(at) || std::find(pinned_.begin(), pinned_.end(), n) != pinned_.end()) continue;
    auto& [vertex, around] = moves.emplace_back(static_cast<std::size_t>(n), std::vector<std::size_t>{});
    for (int way = 0; way < 2 * dim; ++way) {
      const Index<dim> step = (way % 2 * 2 - 1) * Index<dim>::Unit(way / 2);
      const Eigen::Index edge = join(at + step, grid_);
      if (edge < 0 || number_[static_cast<std::size_t>(edge)] < 0) continue;
      if (outer_[vertex] && !outer_[static_cast<std::size_t>(edge)]) continue;
      around.push_back(static_cast<std::size_t>(join(at + 2 * step, grid_)));
    }
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<Vec<dim>> moved = x_;
    for (const auto& [vertex, around] : moves) {
      Vec<dim> mean = Vec<dim>::Zero();
      for (const std::size_t other : around) mean += x_[other] / static_cast<double>(around.size());
      moved[vertex] = outer_[vertex] ? shape_.nearest(mean) : mean;
    }
    x_ = moved;
  }
}

/// Middles of edges (odd = 1), faces and cells: where the element's own polynomial has them, outer ones on
/// the outline.
template <int dim>
void Fitting<dim>::place_middles(int odd) {
  for (const Eigen::Index n : used_) {
    const Index<dim> at = split(n, grid_);
    int odds = 0;
    for (int k = 0; k < dim; ++k) odds += static_cast<int>(at[k] % 2);
    if (odds != odd) continue;
    Vec<dim> middle = Vec<dim>::Zero();
    double length = std::numeric_limits<double>::infinity();
    bool loose = false;
    // Every way to step off along some of the odd axes: -1, 0, 1 on each, not all 0.
    for (int a = 0; a < QuadraticElement<dim>::nodes; ++a) {
      const Index<dim> step =
          QuadraticElement<dim>::place(a).template cast<Eigen::Index>() - Index<dim>::Ones();
      double share = -1;
      bool along = true;
      for (int k = 0; k < dim; ++k) {
        if (step[k] != 0) share *= -0.5;
        along = along && (step[k] == 0 || at[k] % 2 == 1);
      }
      if (!along || step.isZero()) continue;
      middle += share * x_[static_cast<std::size_t>(join(at + step, grid_))];
      const Vec<dim> one = x_[static_cast<std::size_t>(join(at + step, grid_))];
      const Vec<dim> other = x_[static_cast<std::size_t>(join(at - step, grid_))];
      length = std::min(length, (one - other).norm());
      loose = loose || loose_[static_cast<std::size_t>(join(at + step, grid_))];
    }
    Vec<dim>& x = x_[static_cast<std::size_t>(n)];
    x = middle;
    if (loose || !outer_[static_cast<std::size_t>(n)]) continue;
    const Vec<dim> on = shape_.nearest(middle);
    if ((on - middle).norm() <= most_bent * length) x = on;
  }
}

}  // namespace

template <int dim>
FittedGrid<dim>::FittedGrid(const Shape<dim>& shape, double longest, int body) {
  const Fitting<dim> fitting(shape, longest, body);
  side = fitting.side();
  position = fitting.positions();
  node = fitting.elements();
  double volume = 0;
  for (const auto& nodes : node) {
    Eigen::Matrix<double, dim, Element::nodes> corners;
    for (int a = 0; a < Element::nodes; ++a)
      corners.col(a) = position.col(nodes[static_cast<std::size_t>(a)]);
    const Quality quality = quality_of<dim>(corners);
    volume += quality.volume;
    require(
        quality.least_jacobian > 0,
        "solid.body.{}: the element near ({:.4g}) would be turned inside out where it follows the outline; "
        "make solid.fem.element shorter than {:.3g} m",
        body, fmt::join(corners.rowwise().mean().eval(), ", "), side.maxCoeff());
  }
  const double share = volume / ShapeMoments<dim>(shape).volume;
  require(std::abs(share - 1) < most_lost,
          "solid.body.{}: elements of {:.3g} m fill {:.1f} % of its volume; make solid.fem.element shorter",
          body, side.maxCoeff(), 100 * share);
}

template struct FittedGrid<2>;
template struct FittedGrid<3>;

}  // namespace cosurge::fem
