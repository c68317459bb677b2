#include "fluid_solver/walls.hpp"

#include <algorithm>
#include <limits>

#include "common/error.hpp"
#include "fluid_solver/fitted_layout.hpp"

namespace cosurge::fluid {
namespace {

/// Unit normal of a shape's face that lies nearest to x, inside; oblique where faces of a box are equally
/// near.
template <int dim>
Vec<dim> normal_at(const Shape<dim>& shape, const Vec<dim>& x, double spacing) {
  if (!shape.is_box()) return (shape.nearest(x) - x).normalized();
  const Vec<dim> below = x - shape.bounds().min;
  const Vec<dim> above = shape.bounds().max - x;
  const double nearest = std::min(below.minCoeff(), above.minCoeff()) + 1e-6 * spacing;
  Vec<dim> normal = Vec<dim>::Zero();
  for (int axis = 0; axis < dim; ++axis) {
    if (below[axis] <= nearest) normal[axis] -= 1;
    if (above[axis] <= nearest) normal[axis] += 1;
  }
  return normal.normalized();
}

}  // namespace

template <int dim>
Walls<dim>::Walls(const Water<dim>& water, int dummy_layers, bool slip)
    : tank_(water.tank.box),
      spacing_(water.spacing),
      dummy_layers_(dummy_layers),
      thickness_((1 + dummy_layers) * water.spacing),
      tank_motion_(water.tank.motion) {
  parts_.push_back(tank_part());
  for (const Obstacle<dim>& obstacle : water.obstacles) {
    parts_.push_back(obstacle_part(obstacle));
    obstacles_.push_back(obstacle.shape);
  }
  if (slip) return;
  for (Part& part : parts_) std::fill(part.normal.begin(), part.normal.end(), Vec<dim>::Zero());
}

/// Whether a site is already occupied by the tank's walls or an earlier obstacle, or lies so deep in the
/// walls that it needs no particle.
template <int dim>
bool Walls<dim>::taken(const Vec<dim>& x, bool moves) const {
  if (covers(x)) return true;
  const double depth = depth_in_walls(x);
  return depth > 0 && (!moves || depth < thickness_);
}

/// Normal of the floor or side walls behind which x lies; oblique behind edges and corners.
template <int dim>
Vec<dim> Walls<dim>::tank_normal(const Vec<dim>& x) const {
  Vec<dim> normal = Vec<dim>::Zero();
  for (int axis = 0; axis < dim; ++axis) {
    if (x[axis] < tank_.min[axis]) normal[axis] = 1;
    if (axis < dim - 1 && x[axis] > tank_.max[axis]) normal[axis] = -1;
  }
  return normal.normalized();
}

template <int dim>
auto Walls<dim>::tank_part() const -> Part {
  Part part{.place = {}, .normal = {}, .kind = {}, .motion = tank_motion_};
  Box<dim> outer = tank_;
  outer.min.array() -= thickness_;
  outer.max.template head<dim - 1>().array() += thickness_;
  for (const Vec<dim>& x : fill(outer, spacing_)) {
    if (tank_.contains(x)) continue;
    part.place.push_back(x);
    part.normal.push_back(tank_normal(x));
    part.kind.push_back(depth_in_walls(x) < spacing_ ? Kind::wall : Kind::dummy);
  }
  return part;
}

template <int dim>
auto Walls<dim>::obstacle_part(const Obstacle<dim>& obstacle) const -> Part {
  constexpr double nearest = 0.7;  // [spacings] from particles of the tank and of earlier obstacles
  const Shape<dim>& shape = obstacle.shape;
  Part part{
      .place = {}, .normal = {}, .kind = {}, .motion = obstacle.motion, .with_tank = obstacle.with_tank};
  if (!part.motion.moves() && !tank_motion_.moves()) part.with_tank = true;
  const bool moves = !part.with_tank;
  const PointHash<dim> others = particles_near(shape.bounds());
  const std::optional<Box<dim>> tank = moves ? std::nullopt : std::optional(tank_);
  for (const auto& [x, kind] : fitted_layout(shape, tank, dummy_layers_, spacing_)) {
    if (taken(x, moves) || others.any_within(x, nearest * spacing_)) continue;
    part.place.push_back(x);
    part.normal.push_back(normal_at(shape, x, spacing_));
    part.kind.push_back(kind);
  }
  return part;
}

/// Particles of the tank and of earlier obstacles in a box or less than a spacing beside it.
template <int dim>
PointHash<dim> Walls<dim>::particles_near(const Box<dim>& box) const {
  PointHash<dim> near(spacing_);
  const Vec<dim> margin = Vec<dim>::Constant(spacing_);
  const Box<dim> wider(box.min - margin, box.max + margin);
  for (const Part& part : parts_)
    for (const Vec<dim>& x : part.place)
      if (wider.contains(x)) near.add(x);
  return near;
}

template <int dim>
void Walls<dim>::add_to(Particles<dim>& particles) {
  for (Part& part : parts_) {
    part.first_id = particles.size();
    for (std::size_t k = 0; k < part.place.size(); ++k) {
      particles.add(part.kind[k], part.place[k]);
      particles.normal.back() = part.normal[k];
    }
  }
}

template <int dim>
bool Walls<dim>::covers(const Vec<dim>& x) const {
  return std::any_of(obstacles_.begin(), obstacles_.end(),
                     [&](const auto& shape) { return shape.contains(x); });
}

template <int dim>
Box<dim> Walls<dim>::domain() const {
  Box<dim> domain = tank_motion_.sweep(tank_);
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const Box<dim> swept = parts_[k + 1].motion.sweep(obstacles_[k].bounds());
    domain.min = domain.min.cwiseMin(swept.min);
    domain.max = domain.max.cwiseMax(swept.max);
  }
  const double margin = thickness_ + spacing_;
  domain.min.array() -= margin;
  domain.max.array() += margin;
  domain.max[dim - 1] += tank_.max[dim - 1] - tank_.min[dim - 1];
  return domain;
}

template <int dim>
std::vector<WallParticle<dim>> Walls<dim>::sites(std::size_t part) const {
  const Part& of = parts_[part];
  std::vector<WallParticle<dim>> sites;
  for (std::size_t k = 0; k < of.place.size(); ++k)
    if (of.kind[k] == Kind::wall)
      sites.push_back({.id = of.first_id + static_cast<std::int32_t>(k), .place = of.place[k]});
  return sites;
}

template <int dim>
bool Walls<dim>::inside_other(std::size_t part, const Vec<dim>& x, double t) const {
  if (part != 0) {
    const Vec<dim> at = tank_motion_.moves() ? tank_motion_.origin(x, t) : x;
    if (const double depth = depth_in_walls(at); depth > 0 && depth < thickness_) return true;
  }
  for (std::size_t k = 1; k < parts_.size(); ++k)
    if (k != part && obstacles_[k - 1].contains(parts_[k].motion.origin(x, t))) return true;
  return false;
}

/// Depth of a point, in the tank's coordinates, below the surface of its floor or side walls [m]; negative in
/// the tank and above it.
template <int dim>
double Walls<dim>::depth_in_walls(const Vec<dim>& x) const {
  if (x[dim - 1] > tank_.max[dim - 1]) return -1;
  return std::max((tank_.min - x).maxCoeff(), (x - tank_.max).template head<dim - 1>().maxCoeff());
}

template <int dim>
std::size_t Walls<dim>::part_of(std::int32_t id) const {
  const auto next = std::upper_bound(parts_.begin(), parts_.end(), id,
                                     [](std::int32_t wanted, const Part& p) { return wanted < p.first_id; });
  return static_cast<std::size_t>(next - parts_.begin()) - 1;
}

template <int dim>
bool Walls<dim>::moves() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.motion.moves(); });
}

template <int dim>
bool Walls<dim>::moves_in_tank(std::int32_t id) const {
  const std::size_t part = part_of(id);
  return part > 0 && !parts_[part].with_tank;
}

template <int dim>
void Walls<dim>::move(Particles<dim>& particles, double end, double dt) {
  speed_ = 0;
  approach_ = 0;
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.kind[i] != Kind::wall && particles.kind[i] != Kind::dummy) continue;
    const std::size_t number = part_of(particles.id[i]);
    const Part& part = parts_[number];
    const auto k = static_cast<std::size_t>(particles.id[i] - part.first_id);
    particles.kind[i] = part.kind[k];
    particles.normal[i] = part.normal[k];
    particles.u[i].setZero();
    if (!part.motion.moves()) continue;
    const Vec<dim>& X = part.place[k];
    particles.x[i] = part.motion.place(X, end);
    particles.u[i] = (particles.x[i] - part.motion.place(X, end - dt)) / dt;
    particles.normal[i] = part.motion.place(X + part.normal[k], end) - particles.x[i];
    speed_ = std::max(speed_, particles.u[i].norm());
    if (number == 0) continue;
    approach_ = std::max(approach_, (particles.u[i] - tank_velocity(particles.x[i], end, dt)).norm());
  }
}

template <int dim>
double Walls<dim>::speed_between(double from, double to) const {
  double fastest = 0;
  const auto visit = [&](const Motion<dim>& motion, const Box<dim>& box) {
    if (!motion.moves()) return;
    for (int corner = 0; corner < (1 << dim); ++corner) {
      Vec<dim> X;
      for (int k = 0; k < dim; ++k) X[k] = ((corner >> k) & 1) != 0 ? box.max[k] : box.min[k];
      fastest = std::max(fastest, (motion.place(X, to) - motion.place(X, from)).norm() / (to - from));
    }
  };
  visit(tank_motion_, tank_);
  for (std::size_t k = 0; k < obstacles_.size(); ++k) visit(parts_[k + 1].motion, obstacles_[k].bounds());
  return fastest;
}

template <int dim>
void Walls<dim>::require_room(double t) const {
  if (!moves()) return;
  for (std::size_t k = 1; k < parts_.size(); ++k)
    for (const Vec<dim>& X : parts_[k].place)
      require_room(static_cast<std::ptrdiff_t>(k) - 1, parts_[k].motion.place(X, t), t);
}

/// @throws NumericalError if the particle at x of an obstacle lies deeper than a quarter of a spacing in the
/// tank's walls or in an earlier obstacle.
template <int dim>
void Walls<dim>::require_room(std::ptrdiff_t obstacle, const Vec<dim>& x, double t) const {
  const double deep = 0.25 * spacing_;
  const auto part = [&](std::ptrdiff_t k) -> const Part& { return parts_[static_cast<std::size_t>(k + 1)]; };
  const auto refuse = [&](const std::string& what) {
    throw NumericalError(
        fmt::format("fluid.obstacle.{} {} at t = {:.4g} s, at ({:.4g}): shorten the motion, or leave "
                    "room for it",
                    obstacle, what, t, fmt::join(x, ", ")));
  };
  if (!part(obstacle).with_tank) {
    const Vec<dim> at = tank_motion_.moves() ? tank_motion_.origin(x, t) : x;
    if (const double depth = depth_in_walls(at); depth > deep && depth < thickness_)
      refuse(tank_.min[dim - 1] - at[dim - 1] == depth ? "has moved into the tank's floor"
                                                       : "has moved into a side wall of the tank");
  }
  for (std::ptrdiff_t other = 0; other < obstacle; ++other) {
    if (part(obstacle).with_tank && part(other).with_tank) continue;
    if (!part(obstacle).motion.moves() && !part(other).motion.moves()) continue;
    const Shape<dim>& shape = obstacles_[static_cast<std::size_t>(other)];
    const Vec<dim> at = part(other).motion.origin(x, t);
    if (shape.contains(at) && (shape.nearest(at) - at).norm() > deep)
      refuse(fmt::format("and fluid.obstacle.{} have moved into each other", other));
  }
}

template <int dim>
bool Walls<dim>::outside(const Vec<dim>& x, double t) const {
  Box<dim> allowed = tank_;
  allowed.min.array() -= spacing_;
  allowed.max.array() += spacing_;
  allowed.max[dim - 1] = std::numeric_limits<double>::max();  // the domain bounds the open top
  return !allowed.contains(tank_motion_.moves() ? tank_motion_.origin(x, t) : x);
}

template class Walls<2>;
template class Walls<3>;

}  // namespace cosurge::fluid
