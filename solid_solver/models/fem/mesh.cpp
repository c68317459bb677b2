#include "solid_solver/models/fem/mesh.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace cosurge::fem {
namespace {

constexpr double rounding = 1e-6;  // of a side: 0.0800000001 m of elements of 0.02 m are four
constexpr double most_elements = 1e6;

}  // namespace

template <int dim>
Mesh<dim>::Mesh(const v1::Body& body, int index, double longest) : box_(body.box()) {
  const Vec<dim> sides = box_.max - box_.min;
  if (longest == 0) longest = sides.minCoeff() / 3;
  const Vec<dim> counts = (sides / longest).array().max(rounding) - rounding;
  require(counts.array().ceil().prod() <= most_elements,
          "solid.fem.element = {:.3g} m makes {:.3g} elements of solid.body.{}, more than {:.0g}", longest,
          counts.array().ceil().prod(), index, most_elements);
  counts_ = counts.array().ceil().max(1).template cast<Eigen::Index>();
  side_ = sides.array() / counts_.template cast<double>().array();
  number_elements();
  hold(body, index);
}

template <int dim>
void Mesh<dim>::number_elements() {
  const Index grid = 2 * counts_ + Index::Ones();
  Index stride = Index::Ones();
  for (int k = 1; k < dim; ++k) stride[k] = stride[k - 1] * grid[k - 1];
  position_.resize(dim, grid.prod());
  for (Eigen::Index n = 0; n < position_.cols(); ++n)
    for (int k = 0; k < dim; ++k)
      position_(k, n) = box_.min[k] + 0.5 * side_[k] * static_cast<double>(n / stride[k] % grid[k]);
  for (int a = 0; a < Element::nodes; ++a)
    offset_[static_cast<std::size_t>(a)] = stride.dot(Element::place(a).template cast<Eigen::Index>());
  for (Eigen::Index e = 0; e < counts_.prod(); ++e) {
    Eigen::Index rest = e, corner = 0;
    for (int k = 0; k < dim; ++k, rest /= counts_[k - 1]) corner += stride[k] * 2 * (rest % counts_[k]);
    corner_.push_back(corner);
  }
}

template <int dim>
void Mesh<dim>::hold(const v1::Body& body, int index) {
  const double margin = rounding * side_.minCoeff();
  const Supports<dim> supports(body, margin);
  std::vector<Vec<dim>> points;
  for (Eigen::Index n = 0; n < nodes(); ++n) {
    points.emplace_back(position_.col(n));
    held_.push_back(supports.held(points.back()));
  }
  supports.require_points(points, index, "node");
  for (const v1::Box& clamp : body.clamp()) {
    const Box<dim> box(clamp);
    const Vec<dim> widen = Vec<dim>::Constant(margin);
    clamps_.emplace_back(box.min - widen, box.max + widen);
    bool any = false;
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (!clamps_.back().contains(points[n])) continue;
      held_[n].fill(true);
      any = true;
    }
    require(any, "solid.body.{}.clamp.{}: no node of the mesh lies in it; make solid.fem.element <= {:.3g} m",
            index, clamps_.size() - 1, side_.minCoeff() / 2);
  }
  const auto free = [](const Axes<dim>& held) {
    return std::find(held.begin(), held.end(), false) != held.end();
  };
  require(std::any_of(held_.begin(), held_.end(), free),
          "solid.body.{}: it is held all over; choose solid.model = \"rigid\"", index);
}

template <int dim>
typename Mesh<dim>::Place Mesh<dim>::place(const Vec<dim>& x) const {
  Place place{.element = 0, .xi = {}};
  Eigen::Index stride = 1;
  for (int k = 0; k < dim; ++k) {
    const double cell = (x[k] - box_.min[k]) / side_[k];
    const double whole = std::clamp(std::floor(cell), 0.0, static_cast<double>(counts_[k] - 1));
    place.element += stride * static_cast<Eigen::Index>(whole);
    place.xi[k] = 2 * (cell - whole) - 1;
    stride *= counts_[k];
  }
  return place;
}

template <int dim>
bool Mesh<dim>::only_in_clamp(const Vec<dim>& x) const {
  if (outside(x) <= rounding * side_.minCoeff()) return false;
  return std::any_of(clamps_.begin(), clamps_.end(), [&](const Box<dim>& box) { return box.contains(x); });
}

template <int dim>
double Mesh<dim>::outside(const Vec<dim>& x) const {
  return std::max({0.0, (box_.min - x).maxCoeff(), (x - box_.max).maxCoeff()});
}

template class Mesh<2>;
template class Mesh<3>;

}  // namespace cosurge::fem
