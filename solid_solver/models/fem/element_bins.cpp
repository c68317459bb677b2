#include "solid_solver/models/fem/element_bins.hpp"

namespace cosurge::fem {

template <int dim>
ElementBins<dim>::ElementBins(const std::vector<Box<dim>>& boxes) {
  Vec<dim> low = boxes.front().min, high = boxes.front().max, sum = Vec<dim>::Zero();
  for (const Box<dim>& box : boxes) {
    low = low.cwiseMin(box.min);
    high = high.cwiseMax(box.max);
    sum += box.max - box.min;
  }
  // Half a box long, so that a bin has hardly more elements than have boxes around one of its points.
  side_ = 0.5 * sum / static_cast<double>(boxes.size());
  origin_ = low;
  block_.count = bin_of(high) + Index::Ones();
  elements_.resize(static_cast<std::size_t>(block_.cells()));
  for (std::size_t e = 0; e < boxes.size(); ++e) {
    const Index first = bin_of(boxes[e].min), last = bin_of(boxes[e].max);
    Index bin = first;
    for (int axis = 0; axis < dim;) {
      elements_[static_cast<std::size_t>(block_.join(bin))].push_back(static_cast<Eigen::Index>(e));
      for (axis = 0; axis < dim && ++bin[axis] > last[axis]; ++axis) bin[axis] = first[axis];
    }
  }
}

template <int dim>
typename ElementBins<dim>::Index ElementBins<dim>::bin_of(const Vec<dim>& x) const {
  return (x - origin_).cwiseQuotient(side_).array().floor().template cast<Eigen::Index>();
}

template <int dim>
const std::vector<Eigen::Index>& ElementBins<dim>::at(const Vec<dim>& x) const {
  const Eigen::Index bin = elements_.empty() ? -1 : block_.join(bin_of(x));
  return bin < 0 ? none_ : elements_[static_cast<std::size_t>(bin)];
}

template class ElementBins<2>;
template class ElementBins<3>;

}  // namespace cosurge::fem
