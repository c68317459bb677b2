// Points in cells, for searches in a short distance.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "common/vec.hpp"

namespace cosurge::fluid {

/// Points that are added one by one and keep their number.
template <int dim>
class PointHash {
 public:
  /// Searches go as far as `reach` [m].
  explicit PointHash(double reach) : reach_(reach) {}

  void add(const Vec<dim>& x) {
    cells_[key(cell(x))].push_back(static_cast<std::int32_t>(points_.size()));
    points_.push_back(x);
  }

  const std::vector<Vec<dim>>& points() const { return points_; }

  /// Calls visit(number, distance) for each point within `reach` of x, in an order that depends on the points
  /// alone.
  template <typename Visit>
  void near(const Vec<dim>& x, Visit&& visit) const {
    const Cell middle = cell(x);
    constexpr int around = dim == 2 ? 9 : 27;
    for (int k = 0; k < around; ++k) {
      Cell at = middle;
      for (int axis = 0, rest = k; axis < dim; ++axis, rest /= 3) at[axis] += rest % 3 - 1;
      const auto found = cells_.find(key(at));
      if (found == cells_.end()) continue;
      for (const std::int32_t n : found->second) {
        const double distance = (points_[static_cast<std::size_t>(n)] - x).norm();
        if (distance < reach_) visit(n, distance);
      }
    }
  }

  /// Whether a point lies nearer to x than `distance`, which must not exceed the reach.
  bool any_within(const Vec<dim>& x, double distance) const {
    bool any = false;
    near(x, [&](std::int32_t, double d) { any = any || d < distance; });
    return any;
  }

 private:
  using Cell = Eigen::Matrix<std::int64_t, dim, 1>;

  Cell cell(const Vec<dim>& x) const { return (x / reach_).array().floor().template cast<std::int64_t>(); }

  /// 21 bits a coordinate: no two cells of a domain share a key.
  static std::uint64_t key(const Cell& cell) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < dim; ++axis)
      key = key << 21 | (static_cast<std::uint64_t>(cell[axis]) & 0x1fffff);
    return key;
  }

  double reach_;
  std::vector<Vec<dim>> points_;
  std::unordered_map<std::uint64_t, std::vector<std::int32_t>> cells_;
};

}  // namespace cosurge::fluid
