#include "solid_solver/models/fem/fitted_grid.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <set>

#include "common/error.hpp"
#include "solid_solver/models/fem/cell_grid.hpp"
#include "solid_solver/models/fem/outline_features.hpp"
#include "solid_solver/shape_moments.hpp"

namespace cosurge::fem {
namespace {

constexpr int sweeps = 30;          // smoothing sweeps; a displacement spreads over about as many cells
constexpr double most_bent = 0.2;   // largest offset of an edge's middle [edge lengths]
constexpr double flattest = 0.002;  // least determinant of an element's Jacobian, relative to the even cell's
constexpr double most_lost = 0.02;  // largest error of the volume [volume]
constexpr int most_halvings = 12;   // largest number of halvings of a vertex's move
constexpr double alike = 1e-6;      // [cell sides] tolerance for equal distances
constexpr double flat_way = 1.5;    // [-] factor on lengths where the grid's surface has no edge
constexpr Eigen::Index none = -1;

/// Quality of an element, measured at its Gauss points.
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

/// Fits the nodes of a grid to an outline (docs/method_solid.md, section 5).
template <int dim>
class Fitting {
 public:
  Fitting(const Shape<dim>& shape, const CellGrid<dim>& grid)
      : grid_(grid),
        features_(shape),
        x_(grid.positions()),
        fixed_(x_.size(), 0),
        loose_(fixed_),
        patch_(x_.size(), none) {
    pin_corners();
    pin_creases();
    share_out_patches();
    smooth();
    for (int halving = 0; halving < most_halvings; ++halving) {
      for (int odd = 1; odd <= dim; ++odd) place_middles(odd);
      if (!loosen()) return;
    }
  }

  const std::vector<Vec<dim>>& positions() const { return x_; }

 private:
  using Index = typename CellGrid<dim>::Index;

  /// A neighbouring vertex, and the middle of the edge to it.
  struct Neighbour {
    Eigen::Index middle, vertex;
  };
  std::vector<Neighbour> neighbours(Eigen::Index vertex) const;
  bool outer_vertex(Eigen::Index n) const { return grid_.outer(n) && grid_.vertex(n); }
  Vec<dim>& x(Eigen::Index n) { return x_[static_cast<std::size_t>(n)]; }
  char& fixed(Eigen::Index n) { return fixed_[static_cast<std::size_t>(n)]; }
  Eigen::Index& patch(Eigen::Index n) { return patch_[static_cast<std::size_t>(n)]; }

  void pin_corners();
  void pin_creases();
  std::vector<Neighbour> way_along(const Crease& crease);
  void share_out_patches();
  Eigen::Index nearest_patch(const std::vector<Eigen::Index>& nodes);
  void smooth();
  /// Position of a middle by the element's polynomial, and data of its neighbours.
  struct Middle {
    Vec<dim> x = Vec<dim>::Zero();
    double length = std::numeric_limits<double>::infinity();  // length of the shortest edge through it
    bool loose = false;
    Eigen::Index patch = none;
  };
  Middle middle_at(const Index& at) const;
  void place_middles(int odd);
  bool loosen();

  const CellGrid<dim>& grid_;
  OutlineFeatures<dim> features_;
  std::vector<Vec<dim>> x_;           // positions of the nodes
  std::vector<char> fixed_;           // nodes at corners and on creases
  std::vector<char> loose_;           // vertices that were moved back from the outline
  std::vector<Eigen::Index> patch_;   // patch of each outer vertex
  std::vector<Eigen::Index> pinned_;  // vertex of each corner
};

template <int dim>
std::vector<typename Fitting<dim>::Neighbour> Fitting<dim>::neighbours(Eigen::Index vertex) const {
  std::vector<Neighbour> all;
  const Index at = grid_.at(vertex);
  for (int way = 0; way < 2 * dim; ++way) {
    const Index step = (way % 2 * 2 - 1) * Index::Unit(way / 2);
    const Eigen::Index middle = grid_.node(at + step);
    if (middle >= 0) all.push_back({middle, grid_.node(at + 2 * step)});
  }
  return all;
}

/// Moves the nearest outer vertex of the grid to each corner of the outline.
template <int dim>
void Fitting<dim>::pin_corners() {
  const double margin = alike * grid_.side().minCoeff();
  for (const Vec<dim>& corner : features_.corners) {
    Eigen::Index nearest = none;
    for (Eigen::Index n = 0; n < grid_.nodes(); ++n) {
      if (!outer_vertex(n) || fixed(n)) continue;
      if (nearest < 0 || (x(n) - corner).norm() < (x(nearest) - corner).norm() - margin) nearest = n;
    }
    pinned_.push_back(nearest);
    if (nearest < 0) continue;
    x(nearest) = corner;
    fixed(nearest) = 1;
  }
}

/// Distributes the vertices of a path over the grid's surface, from corner to corner, evenly along a crease.
template <int dim>
void Fitting<dim>::pin_creases() {
  if constexpr (dim == 3) {
    for (const Crease& crease : features_.creases) {
      const std::vector<Neighbour> way = way_along(crease);
      std::vector<double> lengths = {0};
      Eigen::Index from = pinned_[crease.ends[0]];
      for (const Neighbour& next : way) {
        lengths.push_back(lengths.back() + (grid_.position(next.vertex) - grid_.position(from)).norm());
        from = next.vertex;
      }
      for (std::size_t k = 0; k < way.size(); ++k) {
        x(way[k].middle) = crease.at(0.5 * (lengths[k] + lengths[k + 1]) / lengths.back());
        fixed(way[k].middle) = 1;
        if (k + 1 < way.size()) x(way[k].vertex) = crease.at(lengths[k + 1] / lengths.back());
        fixed(way[k].vertex) = 1;
      }
    }
  }
}

/// The shortest path over the grid's surface between the vertices at the ends of a crease, through vertices
/// that are not fixed (Dijkstra 1959). Lengths are increased away from the crease, and where the surface has
/// no edge.
template <int dim>
std::vector<typename Fitting<dim>::Neighbour> Fitting<dim>::way_along(const Crease& crease) {
  const Eigen::Index start = pinned_[crease.ends[0]], goal = pinned_[crease.ends[1]];
  std::vector<Neighbour> way;
  if (start < 0 || goal < 0) return way;
  constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<double> length(x_.size(), far);
  std::vector<Neighbour> reached(x_.size());  // the middle before, and the vertex before that
  std::set<std::pair<double, Eigen::Index>> open = {{0, start}};
  length[static_cast<std::size_t>(start)] = 0;
  while (!open.empty() && open.begin()->second != goal) {
    const auto [so_far, n] = *open.begin();
    open.erase(open.begin());
    for (const Neighbour& next : neighbours(n)) {
      if (!grid_.outer(next.middle) || (fixed(next.vertex) && next.vertex != goal)) continue;
      if (fixed(next.middle)) continue;
      const double side = (grid_.position(next.vertex) - grid_.position(n)).norm();
      const double off = next.vertex == goal ? 0 : crease.distance(grid_.position(next.vertex)) / side;
      const bool edge = grid_.around(grid_.at(next.middle)).kept != 2;
      const double there = so_far + side * (edge ? 1 : flat_way) * (1 + off * off);
      double& best = length[static_cast<std::size_t>(next.vertex)];
      if (there >= best) continue;
      open.erase({best, next.vertex});
      open.insert({best = there, next.vertex});
      reached[static_cast<std::size_t>(next.vertex)] = {next.middle, n};
    }
  }
  if (length[static_cast<std::size_t>(goal)] == far) return way;
  for (Eigen::Index n = goal; n != start;) {
    const auto [middle, before] = reached[static_cast<std::size_t>(n)];
    way.push_back({middle, n});
    n = before;
  }
  std::reverse(way.begin(), way.end());
  return way;
}

/// Assigns each group of outer vertices that are connected between creases to the patch that is nearest to
/// the whole group.
template <int dim>
void Fitting<dim>::share_out_patches() {
  std::vector<char> seen = fixed_;
  for (Eigen::Index n = 0; n < grid_.nodes(); ++n) {
    if (!outer_vertex(n) || seen[static_cast<std::size_t>(n)]) continue;
    std::vector<Eigen::Index> part = {n};
    seen[static_cast<std::size_t>(n)] = 1;
    for (std::size_t k = 0; k < part.size(); ++k) {
      for (const Neighbour& next : neighbours(part[k])) {
        if (!grid_.outer(next.middle) || seen[static_cast<std::size_t>(next.vertex)]) continue;
        seen[static_cast<std::size_t>(next.vertex)] = 1;
        part.push_back(next.vertex);
      }
    }
    const Eigen::Index nearest = nearest_patch(part);
    for (const Eigen::Index vertex : part) patch(vertex) = nearest;
  }
}

template <int dim>
Eigen::Index Fitting<dim>::nearest_patch(const std::vector<Eigen::Index>& nodes) {
  std::vector<double> off(features_.patches.size(), 0);
  for (std::size_t p = 0; p < off.size() && off.size() > 1; ++p)
    for (const Eigen::Index n : nodes) off[p] += (features_.patches[p].nearest(x(n)) - x(n)).squaredNorm();
  return std::min_element(off.begin(), off.end()) - off.begin();
}

/// Moves vertices to the mean of their neighbours along edges; outer vertices stay on their patch.
template <int dim>
void Fitting<dim>::smooth() {
  std::vector<std::pair<Eigen::Index, std::vector<Eigen::Index>>> moves;
  for (Eigen::Index n = 0; n < grid_.nodes(); ++n) {
    if (!grid_.vertex(n) || fixed(n)) continue;
    auto& around = moves.emplace_back(n, std::vector<Eigen::Index>{}).second;
    for (const Neighbour& next : neighbours(n))
      if (!grid_.outer(n) || grid_.outer(next.middle)) around.push_back(next.vertex);
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<Vec<dim>> moved = x_;
    for (const auto& [vertex, around] : moves) {
      Vec<dim> mean = Vec<dim>::Zero();
      for (const Eigen::Index other : around) mean += x(other) / static_cast<double>(around.size());
      moved[static_cast<std::size_t>(vertex)] =
          grid_.outer(vertex) ? features_.patches[static_cast<std::size_t>(patch(vertex))].nearest(mean)
                              : mean;
    }
    x_ = moved;
  }
}

/// Evaluates the polynomial from the nodes around the middle on its edge, face or cell: all steps of -1, 0 or
/// 1 along the odd axes, not all 0.
template <int dim>
typename Fitting<dim>::Middle Fitting<dim>::middle_at(const Index& at) const {
  Middle middle;
  for (int a = 0; a < QuadraticElement<dim>::nodes; ++a) {
    const Index step = QuadraticElement<dim>::place(a).template cast<Eigen::Index>() - Index::Ones();
    double share = -1;
    bool along = true;
    for (int k = 0; k < dim; ++k) {
      if (step[k] != 0) share *= -0.5;
      along = along && (step[k] == 0 || at[k] % 2 == 1);
    }
    if (!along || step.isZero()) continue;
    const auto one = static_cast<std::size_t>(grid_.node(at + step)),
               other = static_cast<std::size_t>(grid_.node(at - step));
    middle.x += share * x_[one];
    middle.length = std::min(middle.length, (x_[one] - x_[other]).norm());
    middle.loose = middle.loose || loose_[one];
    middle.patch = std::max(middle.patch, patch_[one]);
  }
  return middle;
}

/// Places the middles of edges (odd = 1), faces and cells where the element's polynomial has them; outer ones
/// go to their patch.
template <int dim>
void Fitting<dim>::place_middles(int odd) {
  for (Eigen::Index n = 0; n < grid_.nodes(); ++n) {
    const Index at = grid_.at(n);
    int odds = 0;
    for (int k = 0; k < dim; ++k) odds += static_cast<int>(at[k] % 2);
    if (odds != odd) continue;
    const Middle middle = middle_at(at);
    if (fixed(n) && !middle.loose) continue;
    x(n) = middle.x;
    if (middle.loose || !grid_.outer(n)) continue;
    const Eigen::Index own = middle.patch < 0 ? nearest_patch({n}) : middle.patch;
    const Vec<dim> on = features_.patches[static_cast<std::size_t>(own)].nearest(middle.x);
    if ((on - middle.x).norm() <= most_bent * middle.length) x(n) = on;
  }
}

/// Moves the vertices of elements that are too flat half the way back to the even grid. Returns whether there
/// were any.
template <int dim>
bool Fitting<dim>::loosen() {
  std::vector<char> flat(x_.size(), 0);
  for (const auto& nodes : grid_.elements()) {
    Eigen::Matrix<double, dim, QuadraticElement<dim>::nodes> corners;
    for (int a = 0; a < corners.cols(); ++a) corners.col(a) = x(nodes[static_cast<std::size_t>(a)]);
    if (quality_of<dim>(corners).least_jacobian > flattest * grid_.side().prod() / (1 << dim)) continue;
    for (const Eigen::Index node : nodes) flat[static_cast<std::size_t>(node)] = 1;
  }
  bool any = false;
  for (Eigen::Index n = 0; n < grid_.nodes(); ++n) {
    const auto at = static_cast<std::size_t>(n);
    if (!flat[at] || !grid_.vertex(n)) continue;
    x_[at] = 0.5 * (x_[at] + grid_.position(n));
    loose_[at] = 1;
    any = true;
  }
  return any;
}

}  // namespace

template <int dim>
FittedGrid<dim>::FittedGrid(const Shape<dim>& shape, double longest, int body) {
  const CellGrid<dim> grid(shape, longest, body);
  side = grid.side();
  node = grid.elements();
  const std::vector<Vec<dim>> x = shape.is_box() ? grid.positions() : Fitting<dim>(shape, grid).positions();
  position =
      Eigen::Map<const Eigen::Matrix<double, dim, Eigen::Dynamic>>(x.front().data(), dim, grid.nodes());
  double volume = 0;
  for (const auto& nodes : node) {
    Eigen::Matrix<double, dim, Element::nodes> corners;
    for (int a = 0; a < Element::nodes; ++a)
      corners.col(a) = position.col(nodes[static_cast<std::size_t>(a)]);
    const Quality quality = quality_of<dim>(corners);
    volume += quality.volume;
    require(quality.least_jacobian > 0,
            "solid.body.{}: the element near ({:.4g}) would be inverted by following the outline; make "
            "solid.fem.element shorter than {:.3g} m",
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
