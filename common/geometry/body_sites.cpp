#include "common/geometry/body_sites.hpp"

namespace cosurge {

template <int dim>
BodySites<dim>::BodySites(const Shape<dim>& shape, double spacing) : spacing_(spacing) {
  const std::vector<Vec<dim>> inside = shape.fill(spacing);
  const auto whole = [&](const Vec<dim>& x) {
    return Index((x / spacing).array().round().template cast<long>());
  };
  lower_ = whole(shape.bounds().min) - Index::Ones();
  block_.count = whole(shape.bounds().max) + Index::Ones() - lower_;
  std::vector<char> in(static_cast<std::size_t>(block_.cells()), 0);
  for (const Vec<dim>& x : inside) {
    const Index k = (x / spacing).array().floor().template cast<long>();
    in[static_cast<std::size_t>(block_.join(k - lower_))] = 1;
  }
  taken_ = shape.is_box() ? in : blocks(in);
  for (const Vec<dim>& x : inside)
    if (contains(x)) sites_.push_back(x);
}

/// Cells that belong to a block of 2^dim cells inside.
template <int dim>
std::vector<char> BodySites<dim>::blocks(const std::vector<char>& inside) const {
  constexpr int size = 1 << dim;
  std::vector<char> in_block(inside.size(), 0);
  for (Eigen::Index first = 0; first < block_.cells(); ++first) {
    std::array<Eigen::Index, size> block{};
    bool whole = true;
    for (int corner = 0; corner < size && whole; ++corner) {
      Index k = block_.split(first);
      for (int axis = 0; axis < dim; ++axis) k[axis] += corner >> axis & 1;
      const Eigen::Index cell = block_.join(k);
      block[static_cast<std::size_t>(corner)] = cell;
      whole = cell >= 0 && inside[static_cast<std::size_t>(cell)] != 0;
    }
    if (!whole) continue;
    for (const Eigen::Index c : block) in_block[static_cast<std::size_t>(c)] = 1;
  }
  return in_block;
}

template <int dim>
bool BodySites<dim>::contains(const Vec<dim>& x) const {
  const Index k = (x / spacing_).array().floor().template cast<long>();
  const Eigen::Index c = block_.join(k - lower_);
  return c >= 0 && taken_[static_cast<std::size_t>(c)] != 0;
}

template class BodySites<2>;
template class BodySites<3>;

}  // namespace cosurge
