#include "fluid_solver/even_layer.hpp"

#include <algorithm>
#include <array>
#include <queue>

namespace cosurge::fluid {
namespace {

constexpr double least_to_grid = 0.75;  // spacings between points of different grids
constexpr double range = 1.3;           // range of the repulsion [spacings]
constexpr double stiffness = 0.25;      // share of the overlap of ranges that a sweep removes
constexpr double at_rest = 0.005;       // [spacings]; the sweeps end when no point moves farther than this

/// Least distance of points that are not on a grid [spacings], such that each point of a round body has the
/// area spacing^(dim-1).
constexpr double touching(int dim) { return dim == 2 ? 0.97 : 0.9; }

/// Least distance of a point that is added at the end [spacings]: gaps of 1.5 spacings along a line get a
/// point.
constexpr double closing(int dim) { return dim == 2 ? 0.75 : touching(dim); }

/// The points that may still be added, each with the distances of the two points that are nearest to it.
template <int dim>
class Front {
 public:
  Front(const std::vector<Vec<dim>>& candidates, double spacing)
      : far_(EvenLayer<dim>::reach * spacing), hash_(far_), nearest_(candidates.size(), {far_, far_}) {
    for (const Vec<dim>& x : candidates) hash_.add(x);
  }

  /// Puts all candidates that are left in the queue.
  void open_all() {
    for (std::size_t k = 0; k < nearest_.size(); ++k)
      queue_.push({nearest_[k][0] + nearest_[k][1], static_cast<std::int32_t>(k)});
  }

  /// Updates the two nearest distances of the candidates near x, where a point has been added.
  void place(const Vec<dim>& x) {
    hash_.near(x, [&](std::int32_t k, double distance) {
      auto& [first, second] = nearest_[static_cast<std::size_t>(k)];
      if (distance >= second) return;
      second = std::max(first, distance);
      first = std::min(first, distance);
      queue_.push({first + second, k});
    });
  }

  /// The candidate with the smallest sum of distances from its two nearest points, among those that are at
  /// least `closest` from all points; -1: none.
  std::int32_t next(double closest) {
    while (!queue_.empty()) {
      const auto [sum, k] = queue_.top();
      queue_.pop();
      const auto& [first, second] = nearest_[static_cast<std::size_t>(k)];
      if (sum == first + second && first >= closest) return k;
    }
    return -1;
  }

 private:
  using Entry = std::pair<double, std::int32_t>;
  double far_;
  PointHash<dim> hash_;
  std::vector<std::array<double, 2>> nearest_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

template <int dim>
EvenLayer<dim>::EvenLayer(const OutlineDepth<dim>& outline, const PointHash<dim>& fixed, double depth,
                          double spacing)
    : outline_(outline), fixed_(fixed), depth_(depth), spacing_(spacing), hash_(reach * spacing) {}

template <int dim>
bool EvenLayer<dim>::occupied(const Vec<dim>& x, double margin) const {
  const double distance = closing(dim) * spacing_ - margin;
  return fixed_.any_within(x, distance) || hash_.any_within(x, distance);
}

template <int dim>
void EvenLayer<dim>::add_grid(const std::vector<Vec<dim>>& grid) {
  for (const Vec<dim>& x : grid) {
    const double distance = least_to_grid * spacing_;
    if (fixed_.any_within(x, distance) || hash_.any_within(x, distance)) continue;
    hash_.add(x);
    points_.push_back(x);
  }
  regular_ = points_.size();
}

template <int dim>
void EvenLayer<dim>::fill(const std::vector<Vec<dim>>& candidates) {
  Front<dim> front(candidates, spacing_);
  for (const Vec<dim>& x : fixed_.points()) front.place(x);
  for (const Vec<dim>& x : points_) front.place(x);
  for (const double distance : {touching(dim) * spacing_, closing(dim) * spacing_}) {
    front.open_all();
    for (std::int32_t k = front.next(distance); k >= 0; k = front.next(distance)) {
      const Vec<dim>& x = candidates[static_cast<std::size_t>(k)];
      front.place(x);
      hash_.add(x);
      points_.push_back(x);
    }
  }
}

/// Indices of the points that may move: those off the grids, and grid points that have such a point near or
/// lie nearer to another point than the grid's pitch.
template <int dim>
std::vector<std::int32_t> EvenLayer<dim>::movable() const {
  std::vector<std::int32_t> movable;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    bool moves = i >= regular_;
    hash_.near(points_[i],
               [&](std::int32_t j, double) { moves = moves || j >= static_cast<std::int32_t>(regular_); });
    if (moves) movable.push_back(static_cast<std::int32_t>(i));
  }
  return movable;
}

template <int dim>
Vec<dim> EvenLayer<dim>::push_on(const PointHash<dim>& all, std::int32_t i) const {
  const Vec<dim>& x = points_[static_cast<std::size_t>(i)];
  Vec<dim> push = Vec<dim>::Zero();
  const auto repel = [&](const Vec<dim>& from, double distance) {
    if (distance < range * spacing_ && distance > 0)
      push += stiffness * (range * spacing_ - distance) / distance * (x - from);
  };
  all.near(x, [&](std::int32_t j, double d) { repel(all.points()[static_cast<std::size_t>(j)], d); });
  fixed_.near(x, [&](std::int32_t j, double d) { repel(fixed_.points()[static_cast<std::size_t>(j)], d); });
  return push;
}

template <int dim>
void EvenLayer<dim>::spread(int sweeps) {
  const std::vector<std::int32_t> moving = movable();
  const auto count = static_cast<std::int64_t>(moving.size());
  std::vector<Vec<dim>> moved(moving.size());
  for (int sweep = 0; sweep < sweeps && count > 0; ++sweep) {
    PointHash<dim> all(reach * spacing_);
    for (const Vec<dim>& x : points_) all.add(x);
#pragma omp parallel for schedule(dynamic, 64)
    for (std::int64_t m = 0; m < count; ++m) {
      const std::int32_t i = moving[static_cast<std::size_t>(m)];
      const Vec<dim>& x = points_[static_cast<std::size_t>(i)];
      moved[static_cast<std::size_t>(m)] = outline_.at_depth(x + push_on(all, i), depth_).value_or(x);
    }
    double farthest = 0;
    for (std::size_t m = 0; m < moving.size(); ++m) {
      Vec<dim>& x = points_[static_cast<std::size_t>(moving[m])];
      farthest = std::max(farthest, (moved[m] - x).norm());
      x = moved[m];
    }
    if (farthest < at_rest * spacing_) return;
  }
}

template class EvenLayer<2>;
template class EvenLayer<3>;

}  // namespace cosurge::fluid
