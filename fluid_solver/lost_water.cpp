#include "fluid_solver/lost_water.hpp"

#include <algorithm>
#include <numeric>

#include "common/error.hpp"

namespace cosurge::fluid {

template <int dim>
LostWater<dim>::LostWater(const Water<dim>& water, const Particles<dim>& particles)
    : tank_(water.tank.box),
      motion_(water.tank.motion),
      most_lost_(water.most_lost),
      water_(static_cast<double>(std::count(particles.kind.begin(), particles.kind.end(), Kind::fluid))),
      place_(static_cast<std::size_t>(particles.size())),
      here_(static_cast<std::size_t>(particles.size())) {}

template <int dim>
void LostWater<dim>::before_step(const Particles<dim>& particles) {
  std::fill(here_.begin(), here_.end(), 0);
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::fluid) continue;
    const auto id = static_cast<std::size_t>(particles.id[i]);
    place_[id] = particles.x[i];
    here_[id] = 1;
  }
}

template <int dim>
void LostWater<dim>::after_step(const Particles<dim>& particles, double t) {
  for (const std::int32_t id : particles.id) here_[static_cast<std::size_t>(id)] = 0;
  for (std::size_t id = 0; id < here_.size(); ++id)
    if (here_[id] != 0) {
      const Vec<dim> at = motion_.moves() ? motion_.origin(place_[id], t) : place_[id];
      ++lost_[side_of(at)];
      if (at[dim - 1] > tank_.max[dim - 1]) ++over_rim_;
    }
  if (lost() <= most_lost_ * water_) return;
  throw NumericalError(fmt::format(
      "{:.0f} of {:.0f} water particles ({:.3g} %) have left the tank by t = {:.4g} s: {}; fluid.most_lost = "
      "{} allows {:.3g} %. {}, or allow more by fluid.most_lost",
      lost(), water_, 100 * lost() / water_, t, where(), most_lost_, 100 * most_lost_,
      2 * over_rim_ > lost() ? "Make the tank higher, or close it by an obstacle as its roof"
                             : "Make time.window smaller"));
}

template <int dim>
std::string LostWater<dim>::side_name(std::size_t side) {
  return fmt::format("{}_{}", "xyz"[side / 2], side % 2 == 0 ? "min" : "max");
}

/// The side of the tank through which a particle at `at`, in the tank's coordinates, has left: the side wall
/// or floor that it is farthest beyond, the top if it is beyond no wall, otherwise the nearest wall.
template <int dim>
std::size_t LostWater<dim>::side_of(const Vec<dim>& at) const {
  constexpr std::size_t top = sides - 1;
  std::array<double, sides> beyond{};
  for (std::size_t side = 0; side < sides; side += 2) {
    const auto axis = static_cast<Eigen::Index>(side / 2);
    beyond[side] = tank_.min[axis] - at[axis];
    beyond[side + 1] = at[axis] - tank_.max[axis];
  }
  const auto wall = std::max_element(beyond.begin(), beyond.end() - 1);
  return *wall <= 0 && beyond[top] > 0 ? top : static_cast<std::size_t>(wall - beyond.begin());
}

template <int dim>
double LostWater<dim>::lost() const {
  return std::accumulate(lost_.begin(), lost_.end(), 0.0);
}

template <int dim>
std::string LostWater<dim>::where() const {
  std::vector<std::string> places;
  for (std::size_t side = 0; side < sides; ++side) {
    if (lost_[side] == 0) continue;
    const auto axis = static_cast<Eigen::Index>(side / 2);
    places.push_back(fmt::format("{:.0f} at {} = {:g} m", lost_[side], "xyz"[side / 2],
                                 side % 2 == 0 ? tank_.min[axis] : tank_.max[axis]));
  }
  return fmt::format("{}, {:.0f} of them over the rim", fmt::join(places, ", "), over_rim_);
}

template <int dim>
std::vector<Column> LostWater<dim>::columns() {
  std::vector<Column> columns = {{"water", "-"}};
  for (std::size_t side = 0; side < sides; ++side) columns.push_back({"lost_" + side_name(side), "-"});
  columns.push_back({"lost_over_rim", "-"});
  return columns;
}

template <int dim>
std::vector<double> LostWater<dim>::values() const {
  std::vector<double> values = {water_ - lost()};
  values.insert(values.end(), lost_.begin(), lost_.end());
  values.push_back(over_rim_);
  return values;
}

template <int dim>
void LostWater<dim>::save(StateWriter& state) const {
  for (const double lost : lost_) state.put(lost);
  state.put(over_rim_);
}

template <int dim>
void LostWater<dim>::restore(StateReader& state) {
  for (double& lost : lost_) state.get(lost);
  state.get(over_rim_);
}

template class LostWater<2>;
template class LostWater<3>;

}  // namespace cosurge::fluid
