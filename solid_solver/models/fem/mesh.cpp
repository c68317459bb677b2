#include "solid_solver/models/fem/mesh.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "common/error.hpp"
#include "solid_solver/models/fem/chosen_grid.hpp"

namespace cosurge::fem {
namespace {

constexpr double rounding = 1e-6;  // [cell sides]

/// Newton's method for sum N_a(xi) X_a = x; false where it finds no xi near the element.
template <int dim>
bool invert(Eigen::Matrix<double, dim, QuadraticElement<dim>::nodes> corners, Vec<dim> x, Vec<dim>& xi) {
  using Element = QuadraticElement<dim>;
  // Coordinates relative to a corner: rounding then depends on the element's size, not on its position.
  const Vec<dim> first = corners.col(0);
  corners.colwise() -= first;
  x -= first;
  constexpr int most = 30;
  constexpr double settled = 1e-14;
  constexpr double far = 3;
  xi.setZero();
  for (int k = 0; k < most; ++k) {
    const Mat<dim> J = corners * Element::gradients(xi);
    if (J.determinant() == 0) return false;
    const Vec<dim> change = J.inverse() * (x - corners * Element::values(xi));
    xi += change;
    if (!(xi.cwiseAbs().maxCoeff() < far)) return false;
    if (change.cwiseAbs().maxCoeff() < settled) return true;
  }
  return (x - corners * Element::values(xi)).norm() < 1e-12 * (corners.col(0) - corners.col(2)).norm();
}

}  // namespace

template <int dim>
Mesh<dim>::Mesh(const Body<dim>& body, std::size_t index, double longest)
    : shape_(body.shape),
      grid_(chosen_grid(shape_, longest, static_cast<int>(index))),
      margin_(rounding * side().minCoeff()),
      clamps_(body.clamps) {
  hold(body, index);
  const Vec<dim> margin = Vec<dim>::Constant(side().norm());
  for (Eigen::Index e = 0; e < elements() && !even(); ++e) {
    const auto X = corners(e);
    near_.emplace_back(X.rowwise().minCoeff() - margin, X.rowwise().maxCoeff() + margin);
  }
  if (!even()) bins_ = ElementBins<dim>(near_);
}

template <int dim>
void Mesh<dim>::hold(const Body<dim>& body, std::size_t index) {
  const Supports<dim> supports(body.supports, margin_);
  std::vector<Vec<dim>> points;
  for (Eigen::Index n = 0; n < nodes(); ++n) {
    points.emplace_back(position().col(n));
    held_.push_back(supports.held(points.back()));
  }
  supports.require_points(points, index, "node");
  for (std::size_t c = 0; c < clamps_.size(); ++c) {
    bool any = false;
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (clamps_[c].outside(points[n]) > margin_) continue;
      held_[n].fill(true);
      any = true;
    }
    require(any, "solid.body.{}.clamp.{}: contains no node of the mesh; make solid.fem.element <= {:.3g} m",
            index, c, side().minCoeff() / 2);
  }
  const auto free = [](const Axes<dim>& held) {
    return std::find(held.begin(), held.end(), false) != held.end();
  };
  require(std::any_of(held_.begin(), held_.end(), free),
          "solid.body.{}: all of it is held; choose solid.model = \"rigid\"", index);
}

template <int dim>
Eigen::Matrix<double, dim, Mesh<dim>::Element::nodes> Mesh<dim>::corners(Eigen::Index element) const {
  Eigen::Matrix<double, dim, Element::nodes> all;
  for (int a = 0; a < Element::nodes; ++a) all.col(a) = position().col(node(element, a));
  return all;
}

template <int dim>
typename Mesh<dim>::Place Mesh<dim>::place_in_grid(const Vec<dim>& x) const {
  Place place{.element = 0, .xi = {}};
  const Box<dim>& box = shape_.bounds();
  Eigen::Index stride = 1;
  for (int k = 0; k < dim; ++k) {
    const double count = std::round((box.max[k] - box.min[k]) / side()[k]);
    const double cell = (x[k] - box.min[k]) / side()[k];
    const double whole = std::clamp(std::floor(cell), 0.0, count - 1);
    place.element += stride * static_cast<Eigen::Index>(whole);
    place.xi[k] = 2 * (cell - whole) - 1;
    stride *= static_cast<Eigen::Index>(count);
  }
  return place;
}

template <int dim>
typename Mesh<dim>::Place Mesh<dim>::place(const Vec<dim>& x) const {
  if (even()) return place_in_grid(x);
  Place best{.element = -1, .xi = {}};
  double least = std::numeric_limits<double>::infinity();
  const auto try_element = [&](Eigen::Index e) {
    Vec<dim> xi;
    if (!invert<dim>(corners(e), x, xi) || xi.cwiseAbs().maxCoeff() >= least) return;
    least = xi.cwiseAbs().maxCoeff();
    best = {.element = e, .xi = xi};
  };
  // An element whose box of corners contains x most likely contains x; then no other needs to be tried.
  const std::vector<Eigen::Index>& candidates = bins_.at(x);
  const Vec<dim> margin = Vec<dim>::Constant(side().norm());
  for (const bool wide : {false, true}) {
    for (const Eigen::Index e : candidates) {
      const Box<dim>& box = near_[static_cast<std::size_t>(e)];
      const bool tight = Box<dim>(box.min + margin, box.max - margin).contains(x);
      if (tight == wide || !box.contains(x)) continue;
      try_element(e);
      if (least <= 1) return best;
    }
  }
  if (best.element < 0)
    throw NumericalError(
        fmt::format("solid: no element near the interface point ({}); make solid.fem.element shorter",
                    fmt::join(x.begin(), x.end(), ", ")));
  return best;
}

template <int dim>
bool Mesh<dim>::only_in_clamp(const Vec<dim>& x) const {
  if (outside(x) <= margin_) return false;
  return std::any_of(clamps_.begin(), clamps_.end(),
                     [&](const Shape<dim>& clamp) { return clamp.outside(x) <= margin_; });
}

template class Mesh<2>;
template class Mesh<3>;

}  // namespace cosurge::fem
