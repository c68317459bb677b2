#include "fluid_solver/neighbors.hpp"

#include "common/error.hpp"

namespace cosurge::fluid {
namespace {

constexpr int expected_neighbors(int dim) {
  return dim == 2 ? 20 : 50;
}  // 12 and 32 on the lattice, and disorder

template <int dim>
void check_crowding(const CellGrid<dim>& grid, const Particles<dim>& particles) {
  constexpr int widest = dim == 2 ? 25 : 125;  // cells that the pressure equation looks at around one
  constexpr int most = most_entries(dim) / widest;
  for (int c = 0; c < grid.cells(); ++c) {
    if (grid.population(c) <= most) continue;
    const Vec<dim> x = particles.x[static_cast<std::size_t>(grid.first(c))];
    throw NumericalError(
        fmt::format("{} particles lie in one cell of the neighbour search, at ({:.4g}): the water has "
                    "collapsed there; lower time.window or fluid.compressibility",
                    grid.population(c), fmt::join(x, ", ")));
  }
}

}  // namespace

template <int dim>
void Neighbors<dim>::rebuild(Particles<dim>& particles) {
  particles.reorder(grid_.sort(particles.x));
  check_crowding(grid_, particles);
  const double re2 = re_ * re_;
  const auto* x = particles.x.data();
  const auto list = [&](int i, std::int64_t place) {
    if (!has_pressure(particles.kind[i])) return std::int64_t{0};
    std::int32_t* const entries = index_.data() + place;
    std::int64_t count = 0;
    grid_.ranges(grid_.cell_of(x[i]), 1, [&](std::int32_t first, std::int32_t last) {
      for (std::int32_t j = first; j < last; ++j) {
        entries[count] = j;
        count +=
            static_cast<std::int64_t>((x[j] - x[i]).squaredNorm() < re2) & static_cast<std::int64_t>(j != i);
      }
    });
    for (std::int64_t k = place; dim == 2 && k < place + count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      distance_[at] = (x[index_[at]] - x[i]).norm();
      weight_[at] = weight(distance_[at], re_);
    }
    return count;
  };
  const auto prepare = [&](std::int64_t entries) {
    const auto room = static_cast<std::size_t>(entries);
    index_.make_room(room);
    if (dim == 2) distance_.make_room(room), weight_.make_room(room);
  };
  rows_.fill(particles.size(), expected_neighbors(dim), most_entries(dim), prepare, list);
}

template class Neighbors<2>;
template class Neighbors<3>;

}  // namespace cosurge::fluid
