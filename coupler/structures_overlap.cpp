#include "coupler/structures_overlap.hpp"

#include <algorithm>
#include <numeric>

namespace cosurge {

std::optional<Overlap> find_overlap(const Field& places, const std::vector<int>& structure, double distance) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(places.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return places(0, a) < places(0, b); });
  for (std::size_t a = 0; a < order.size(); ++a) {
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const Eigen::Index i = order[a], j = order[b];
      if (places(0, j) - places(0, i) >= distance) break;
      if (structure[static_cast<std::size_t>(i)] == structure[static_cast<std::size_t>(j)]) continue;
      if ((places.col(i) - places.col(j)).norm() < distance) return Overlap{.first = i, .second = j};
    }
  }
  return std::nullopt;
}

}  // namespace cosurge
