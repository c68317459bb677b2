// A block of cells in space.
#pragma once

#include <vector>

#include "common/vec.hpp"

namespace cosurge {

/// So many cells along each axis, numbered with the first axis fastest.
template <int dim>
struct CellBlock {
  using Index = Eigen::Matrix<Eigen::Index, dim, 1>;

  Index count = Index::Zero();

  Eigen::Index cells() const { return count.prod(); }

  /// Number of a cell; -1 outside.
  Eigen::Index join(const Index& k) const {
    if ((k.array() < 0).any() || (k.array() >= count.array()).any()) return -1;
    Eigen::Index cell = 0;
    for (int axis = dim - 1; axis >= 0; --axis) cell = cell * count[axis] + k[axis];
    return cell;
  }

  Index split(Eigen::Index cell) const {
    Index k;
    for (int axis = 0; axis < dim; cell /= count[axis], ++axis) k[axis] = cell % count[axis];
    return k;
  }

  /// Number of parts of the cells that are `kept` (not 0) that do not touch by faces.
  int parts(std::vector<char> kept) const {
    int parts = 0;
    for (Eigen::Index start = 0; start < cells(); ++start) {
      if (!kept[static_cast<std::size_t>(start)]) continue;
      ++parts;
      std::vector<Eigen::Index> open = {start};
      kept[static_cast<std::size_t>(start)] = 0;
      while (!open.empty()) {
        const Index k = split(open.back());
        open.pop_back();
        for (int way = 0; way < 2 * dim; ++way) {
          const Eigen::Index next = join(k + (way % 2 * 2 - 1) * Index::Unit(way / 2));
          if (next < 0 || !kept[static_cast<std::size_t>(next)]) continue;
          kept[static_cast<std::size_t>(next)] = 0;
          open.push_back(next);
        }
      }
    }
    return parts;
  }
};

}  // namespace cosurge
