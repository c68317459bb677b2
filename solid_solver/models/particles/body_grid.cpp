#include "solid_solver/models/particles/body_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "common/geometry/body_sites.hpp"

namespace cosurge::particles {
namespace {

constexpr double coincide = 1e-6;  // [spacings] tolerance for equal sites

template <int dim>
struct LatticeOrder {
  bool operator()(const SiteIndex<dim>& a, const SiteIndex<dim>& b) const {
    for (int k = dim - 1; k > 0; --k)
      if (a[k] != b[k]) return a[k] < b[k];
    return a[0] < b[0];
  }
};

template <int dim>
using Sites = std::map<SiteIndex<dim>, bool, LatticeOrder<dim>>;  // site -> held

template <int dim>
bool feels_free_particle(const SiteIndex<dim>& k, const Sites<dim>& sites, const Stencil<dim>& stencil) {
  return std::any_of(stencil.neighbors.begin(), stencil.neighbors.end(), [&](const Neighbor<dim>& n) {
    const auto found = sites.find(SiteIndex<dim>(k + n.offset));
    return found != sites.end() && !found->second;
  });
}

}  // namespace

template <int dim>
BodyGrid<dim>::BodyGrid(const Body<dim>& body, std::size_t index, const Stencil<dim>& stencil)
    : spacing_(stencil.spacing), shape_(body.shape), clamps_(body.clamps) {
  Sites<dim> sites;
  const BodySites<dim> own(shape_, spacing_);
  for (const Vec<dim>& x : own.all()) sites[index_of(x)] = false;
  for (const Shape<dim>& clamp : clamps_)
    for (const Vec<dim>& x : clamp.fill(spacing_)) sites[index_of(x)] = true;
  const Supports<dim> supports(body.supports, coincide * spacing_);
  std::vector<SiteIndex<dim>> kept;
  for (const auto& [k, held] : sites) {
    if (held && !feels_free_particle(k, sites, stencil)) continue;
    kept.push_back(k);
    positions_.push_back(site<dim>(k, spacing_));
    held_.push_back(held);
    held_axes_.push_back(supports.held(positions_.back()));
    if (held) held_axes_.back().fill(true);
  }
  check(index);
  supports.require_points(positions_, index, "particle");
  number_slots(kept, stencil.reach);
}

template <int dim>
void BodyGrid<dim>::check(std::size_t index) const {
  const double thickness = (shape_.bounds().max - shape_.bounds().min).minCoeff() / spacing_;
  require(thickness > 1.5, "solid.body.{}: {:.3g} spacings thick, particles need at least 2", index,
          thickness);
  const auto any_free = [](const Axes<dim>& axes) {
    return std::find(axes.begin(), axes.end(), false) != axes.end();
  };
  require(std::any_of(held_axes_.begin(), held_axes_.end(), any_free),
          "solid.body.{}: all of it is held; choose solid.model = \"rigid\"", index);
}

template <int dim>
void BodyGrid<dim>::number_slots(const std::vector<SiteIndex<dim>>& sites, int reach) {
  lower_ = upper_ = sites.front();
  for (const SiteIndex<dim>& k : sites) {
    lower_ = lower_.cwiseMin(k);
    upper_ = upper_.cwiseMax(k);
  }
  // `reach` void slots between rows of sites, so that no neighbour lies in the next row
  stride_[0] = 1;
  for (int k = 1; k < dim; ++k) stride_[k] = stride_[k - 1] * (upper_[k - 1] - lower_[k - 1] + 1 + reach);
  const Eigen::Index farthest = reach * stride_.sum();
  const Eigen::Index used = stride_.dot(upper_ - lower_) + 1;
  first_ = farthest;
  last_ = first_ + (used + lanes - 1) / lanes * lanes;
  slot_count_ = last_ + farthest;
  particle_of_slot_.assign(static_cast<std::size_t>(slot_count_), -1);
  for (const SiteIndex<dim>& k : sites) {
    particle_of_slot_[first_ + stride_.dot(k - lower_)] = static_cast<long>(slots_.size());
    slots_.push_back(first_ + stride_.dot(k - lower_));
  }
}

template <int dim>
Eigen::Index BodyGrid<dim>::shift(const SiteIndex<dim>& offset) const {
  return stride_.dot(offset);
}

template <int dim>
SiteIndex<dim> BodyGrid<dim>::index_of(const Vec<dim>& x) const {
  return (x / spacing_).array().floor().template cast<long>();
}

template <int dim>
long BodyGrid<dim>::particle_at(const Vec<dim>& x) const {
  const SiteIndex<dim> k = index_of(x);
  if ((k.array() < lower_.array()).any() || (k.array() > upper_.array()).any()) return -1;
  if ((site<dim>(k, spacing_) - x).norm() > coincide * spacing_) return -1;
  return particle_of_slot_[first_ + stride_.dot(k - lower_)];
}

template <int dim>
std::vector<std::size_t> BodyGrid<dim>::particles_near(const Vec<dim>& x, double radius) const {
  std::vector<std::size_t> near;
  const Vec<dim> reach = Vec<dim>::Constant(radius);
  const SiteIndex<dim> lower = index_of(x - reach).cwiseMax(lower_),
                       upper = index_of(x + reach).cwiseMin(upper_);
  if ((lower.array() > upper.array()).any()) return near;
  SiteIndex<dim> k = lower;
  for (int axis = 0; axis < dim;) {
    const long particle = particle_of_slot_[first_ + stride_.dot(k - lower_)];
    if (particle >= 0 && (positions_[particle] - x).norm() < radius) near.push_back(particle);
    for (axis = 0; axis < dim && ++k[axis] > upper[axis]; ++axis) k[axis] = lower[axis];
  }
  return near;
}

template <int dim>
bool BodyGrid<dim>::in_clamp(const Vec<dim>& x) const {
  return std::any_of(clamps_.begin(), clamps_.end(),
                     [&](const Shape<dim>& clamp) { return clamp.contains(x); });
}

template <int dim>
double BodyGrid<dim>::share_outside_clamps(const Vec<dim>& x, const Vec<dim>& r0) const {
  double share = 1;
  for (const Shape<dim>& clamp : clamps_)
    if (clamp.contains(x + r0)) share = std::min(share, clamp.share_outside(x, r0));
  return share;
}

template <int dim>
bool BodyGrid<dim>::in_shape(const Vec<dim>& x) const {
  return shape_.outside(x) <= coincide * spacing_;
}

template class BodyGrid<2>;
template class BodyGrid<3>;

}  // namespace cosurge::particles
