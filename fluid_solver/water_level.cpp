#include "fluid_solver/water_level.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "fluid_solver/particles_around.hpp"

namespace cosurge::fluid {
namespace {

constexpr double linked = 1.5;  // spacings
constexpr double fewest_supports =
    2;  // smallest part that counts as water, not as spray [particles in a full support]

/// Particles in a ball of radius r_e.
template <int dim>
double in_support(double re, double spacing) {
  return (dim == 2 ? 1.0 : 4.0 / 3) * std::numbers::pi * std::pow(re / spacing, dim);
}

/// Root of the tree that contains i; shortens the path to it.
std::int32_t root_of(std::int32_t i, std::vector<std::int32_t>& parent) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

/// The largest part with water within r_e of the line, and its height there above the foot; -1: only spray.
template <int dim>
std::pair<std::int32_t, double> part_near(const Mps<dim>& mps, const WaterParts& parts,
                                          const GaugeLine<dim>& line, double spacing) {
  const Particles<dim>& particles = mps.particles();
  const double re = mps.neighbors().re(), fewest = fewest_supports * in_support<dim>(re, spacing);
  std::int32_t largest = -1;
  double highest = 0;
  for (int i = 0; i < particles.size(); ++i) {
    const std::int32_t part = parts.part[i];
    if (part < 0 || parts.size[part] < fewest) continue;
    const Vec<dim> way = particles.x[i] - line.foot;
    const double height = way.dot(line.up);
    if ((way - height * line.up).norm() >= re) continue;
    if (largest < 0 || parts.size[part] > parts.size[largest]) largest = part, highest = 0;
    if (part == largest) highest = std::max(highest, height);
  }
  return {largest, highest};
}

}  // namespace

template <int dim>
WaterParts connected_water(const Mps<dim>& mps, double spacing) {
  const Particles<dim>& particles = mps.particles();
  std::vector<std::int32_t> parent(static_cast<std::size_t>(particles.size()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto water = [&](int i) { return particles.kind[i] == Kind::fluid; };
  for (int i = 0; i < particles.size(); ++i) {
    if (!water(i)) continue;
    mps.neighbors().each(particles, i, [&](int j, const Vec<dim>&, double r) {
      if (j >= i || !water(j) || r >= linked * spacing) return;
      const std::int32_t one = root_of(i, parent), other = root_of(j, parent);
      parent[std::max(one, other)] = std::min(one, other);  // the root of a tree is its first particle
    });
  }
  WaterParts parts{.part = std::vector<std::int32_t>(parent.size(), -1), .size = {}};
  for (int i = 0; i < particles.size(); ++i) {
    if (!water(i)) continue;
    const std::int32_t root = root_of(i, parent);
    if (root == i) {
      parts.part[i] = static_cast<std::int32_t>(parts.size.size());
      parts.size.push_back(0);
    }
    parts.part[i] = parts.part[root];
    ++parts.size[parts.part[i]];
  }
  return parts;
}

template <int dim>
double level_over(const Mps<dim>& mps, const WaterParts& parts, const GaugeLine<dim>& line, double spacing) {
  const double re = mps.neighbors().re();
  // Integral of (1 - r / r_e)^2 over the support, times the number of particles per volume.
  const double full = (dim == 2 ? 1.0 / 6 : 2.0 / 15) * std::numbers::pi * std::pow(re / spacing, dim);
  const auto [part, highest] = part_near(mps, parts, line, spacing);
  if (part < 0) return 0;
  const auto share = [&, part = part](double height) {
    double water = 0;
    double others = 0;
    each_around(mps, Vec<dim>(line.foot + height * line.up), [&](int j, const Vec<dim>&, double r) {
      const double w = (1 - r / re) * (1 - r / re);
      if (mps.particles().kind[j] != Kind::fluid)
        others += w;
      else if (parts.part[j] == part)
        water += w;
    });
    return water / std::max(full - others, 0.3 * full);  // next to a wall half is left
  };
  const double step = 0.5 * spacing;
  double above = highest + re;
  while (above > 0 && share(above - step) < 0.5) above -= step;
  if (above <= 0) return 0;
  const double high = share(above);
  return above - step * (0.5 - high) / (share(above - step) - high);
}

template WaterParts connected_water(const Mps<2>&, double);
template WaterParts connected_water(const Mps<3>&, double);
template double level_over<2>(const Mps<2>&, const WaterParts&, const GaugeLine<2>&, double);
template double level_over<3>(const Mps<3>&, const WaterParts&, const GaugeLine<3>&, double);

}  // namespace cosurge::fluid
