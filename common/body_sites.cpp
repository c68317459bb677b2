#include "common/body_sites.hpp"

namespace cosurge {

template <int dim>
BodySites<dim>::BodySites(const v1::Body& body, double spacing) : spacing_(spacing) {
  const Shape<dim> shape(shape_of(body));
  const std::vector<Vec<dim>> inside = shape.fill(spacing);
  const auto whole = [&](const Vec<dim>& x) {
    return Index((x / spacing).array().round().template cast<long>());
  };
  lower_ = whole(shape.bounds().min) - Index::Ones();
  count_ = whole(shape.bounds().max) + Index::Ones() - lower_;
  std::vector<char> in(static_cast<std::size_t>(count_.prod()), 0);
  for (const Vec<dim>& x : inside) {
    const Index k = (x / spacing).array().floor().template cast<long>();
    in[static_cast<std::size_t>(cell(k))] = 1;
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
  for (long first = 0; first < count_.prod(); ++first) {
    std::array<long, size> block{};
    bool whole = true;
    for (int corner = 0; corner < size && whole; ++corner) {
      Index k = place(first);
      for (int axis = 0; axis < dim; ++axis) k[axis] += corner >> axis & 1;
      block[static_cast<std::size_t>(corner)] = cell(k);
      whole = cell(k) >= 0 && inside[static_cast<std::size_t>(cell(k))] != 0;
    }
    if (!whole) continue;
    for (const long c : block) in_block[static_cast<std::size_t>(c)] = 1;
  }
  return in_block;
}

template <int dim>
long BodySites<dim>::cell(const Index& k) const {
  const Index from = k - lower_;
  if ((from.array() < 0).any() || (from.array() >= count_.array()).any()) return -1;
  long cell = 0;
  for (int axis = dim - 1; axis >= 0; --axis) cell = cell * count_[axis] + from[axis];
  return cell;
}

template <int dim>
typename BodySites<dim>::Index BodySites<dim>::place(long cell) const {
  Index k;
  for (int axis = 0; axis < dim; cell /= count_[axis], ++axis) k[axis] = lower_[axis] + cell % count_[axis];
  return k;
}

template <int dim>
bool BodySites<dim>::contains(const Vec<dim>& x) const {
  const long c = cell((x / spacing_).array().floor().template cast<long>());
  return c >= 0 && taken_[static_cast<std::size_t>(c)] != 0;
}

template <int dim>
int BodySites<dim>::parts() const {
  std::vector<char> left = taken_;
  int parts = 0;
  for (std::size_t start = 0; start < left.size(); ++start) {
    if (left[start] == 0) continue;
    ++parts;
    std::vector<long> open = {static_cast<long>(start)};
    left[start] = 0;
    while (!open.empty()) {
      const Index k = place(open.back());
      open.pop_back();
      for (int side = 0; side < 2 * dim; ++side) {
        const long next = cell(k + (side % 2 * 2 - 1) * Index::Unit(side / 2));
        if (next < 0 || left[static_cast<std::size_t>(next)] == 0) continue;
        left[static_cast<std::size_t>(next)] = 0;
        open.push_back(next);
      }
    }
  }
  return parts;
}

template class BodySites<2>;
template class BodySites<3>;

}  // namespace cosurge
