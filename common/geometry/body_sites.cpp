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
  if (!shape.is_box()) take_flat_ends(in);
  for (const Vec<dim>& x : inside)
    if (contains(x)) sites_.push_back(x);
}

/// Takes cells inside that touch a taken cell and belong to a block if the first and the last layer along
/// each axis is repeated beyond it: a body that ends in a plane of the lattice, such as a leaning plate on
/// the floor, keeps the sites of its end.
template <int dim>
void BodySites<dim>::take_flat_ends(const std::vector<char>& inside) {
  Index first = block_.count, last = -Index::Ones();
  for (Eigen::Index c = 0; c < block_.cells(); ++c) {
    if (inside[static_cast<std::size_t>(c)] == 0) continue;
    first = first.cwiseMin(block_.split(c));
    last = last.cwiseMax(block_.split(c));
  }
  std::vector<char> longer = inside;
  const auto each_end = [&](const Index& k, auto&& visit) {
    for (int axis = 0; axis < dim; ++axis)
      for (const int side : {-1, 1})
        if (k[axis] == (side < 0 ? first : last)[axis])
          if (const Eigen::Index c = block_.join(k + side * Index::Unit(axis)); c >= 0) visit(c);
  };
  for (Eigen::Index c = 0; c < block_.cells(); ++c)
    if (inside[static_cast<std::size_t>(c)] != 0)
      each_end(block_.split(c), [&](Eigen::Index beyond) { longer[static_cast<std::size_t>(beyond)] = 1; });
  const std::vector<char> in_block = blocks(longer), taken = taken_;
  for (Eigen::Index c = 0; c < block_.cells(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    if (inside[at] == 0 || in_block[at] == 0) continue;
    for (int way = 0; way < 2 * dim; ++way) {
      const Eigen::Index next = block_.join(block_.split(c) + (way % 2 * 2 - 1) * Index::Unit(way / 2));
      if (next >= 0 && taken[static_cast<std::size_t>(next)] != 0) taken_[at] = 1;
    }
  }
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
