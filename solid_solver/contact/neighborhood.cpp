#include "solid_solver/contact/neighborhood.hpp"

#include <algorithm>
#include <limits>

#include "common/error.hpp"

namespace cosurge::contact {
namespace {

constexpr double reach_in_spacings = 1.5;
constexpr double touching = 1e-6;  // [spacings] gap that rounding leaves between adjacent faces
// [spacings] Approach without a contact force for clamped bodies that touch a wall of the tank at the start.
// A clamped body that reaches from wall to wall slides along the walls and bulges slightly towards them; this
// is not an impact. Obstacles and other bodies, on which a body may lean, are felt at once.
constexpr double play = 0.05;

// Shares of the stiffness: in a flat contact the vertices of both sides press on the facets of the other
// side, and the vertices of each body count in both directions.
constexpr double beside_obstacle = 0.5;
constexpr double beside_body = 0.25;

template <int dim>
Box<dim> box_of(const Field& x) {
  return {x.rowwise().minCoeff(), x.rowwise().maxCoeff()};
}

template <int dim>
bool overlap(const Box<dim>& a, const Box<dim>& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

template <int dim>
Touch<dim> nowhere(int body, int other, double share) {
  Touch<dim> touch{};
  touch.body = body;
  touch.other = other;
  touch.share = share;
  touch.vertex.fill(-1);
  return touch;
}

}  // namespace

template <int dim>
Neighborhood<dim>::Neighborhood(const Structure<dim>& structure, const Surroundings<dim>& surroundings)
    : spacing_(structure.spacing), reach_(reach_in_spacings * structure.spacing) {
  if (surroundings.tank) tank_.emplace_back(*surroundings.tank);
  for (const Obstacle<dim>& obstacle : surroundings.obstacles)
    obstacles_.emplace_back(obstacle.shape, obstacle.motion, spacing_, reach_);
  first_.push_back(0);
  for (const Body<dim>& body : structure.bodies) {
    shapes_.push_back(body.shape);
    boundaries_.emplace_back(body.shape, spacing_);
    clamped_.push_back(body.clamps.empty() && body.supports.empty() ? 0 : 1);
    const Boundary<dim>& made = boundaries_.back();
    first_.push_back(first_.back() + made.position.cols());
    body_.insert(body_.end(), made.area.size(), bodies() - 1);
    area_.insert(area_.end(), made.area.begin(), made.area.end());
  }
  reference_.resize(dim, first_.back());
  for (int b = 0; b < bodies(); ++b)
    reference_.middleCols(first_[b], first_[b + 1] - first_[b]) = boundaries_[b].position;
  held_.assign(area_.size(), 0);
}

template <int dim>
std::string Neighborhood<dim>::name(int other) const {
  if (other < walls()) return tank_.front().name(other);
  if (other < first_body()) return fmt::format("fluid.obstacle.{}", other - walls());
  return fmt::format("solid.body.{}", other - first_body());
}

template <int dim>
Field Neighborhood<dim>::of_body(const Field& all, int b) const {
  return all.middleCols(first_[b], first_[b + 1] - first_[b]);
}

template <int dim>
Box<dim> Neighborhood<dim>::widened(const Box<dim>& box) const {
  const Vec<dim> reach = Vec<dim>::Constant(reach_);
  return {box.min - reach, box.max + reach};
}

template <int dim>
typename Neighborhood<dim>::Touches Neighborhood<dim>::within_reach(const Field& x, double t) const {
  Touches touches;
  if (!tank_.empty()) add_walls(x, t, touches);
  std::vector<Box<dim>> boxes;
  for (int b = 0; b < bodies(); ++b) boxes.push_back(widened(box_of<dim>(of_body(x, b))));
  for (int b = 0; b < bodies(); ++b) {
    for (int o = 0; o < static_cast<int>(obstacles_.size()); ++o)
      if (overlap(boxes[b], obstacles_[o].box(t))) add_obstacle(o, b, x, t, touches);
    for (int a = 0; a < b; ++a)
      if (overlap(boxes[a], boxes[b])) add_bodies(a, b, x, touches);
  }
  return touches;
}

template <int dim>
void Neighborhood<dim>::add_walls(const Field& x, double t, Touches& touches) const {
  const TankWalls<dim>& tank = tank_.front();
  const Motion<dim>& motion = tank.motion();
  const bool moves = motion.moves();
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    if (held_[v] != 0) continue;
    const Vec<dim> at = x.col(v), home = moves ? motion.origin(at, t) : at;
    for (int wall = 0; wall < walls(); ++wall) {
      const double gap = tank.gap(wall, home);
      if (gap > reach_) continue;
      Touch<dim> touch = nowhere<dim>(body_[v], wall, 1);
      touch.gap =
          gap - rest_gap(tank.gap(wall, reference_.col(v)), clamped_[body_[v]] != 0 ? play * spacing_ : 0);
      touch.normal = tank.normal(wall);
      if (moves) {
        touch.normal = motion.place(home + touch.normal, t) - motion.place(home, t);
        touch.prescribed_rate = -touch.normal.dot(motion.velocity(home, t));
      }
      touch.place = at;
      touch.area = area_[v];
      touch.vertex[0] = static_cast<int>(v);
      touch.weight[0] = 1;
      touches.push_back(touch);
    }
  }
}

/// Tests the body's vertices against the obstacle's facets, and the obstacle's vertices against the body's.
template <int dim>
void Neighborhood<dim>::add_obstacle(int o, int b, const Field& x, double t, Touches& touches) const {
  const ObstacleBoundary<dim>& obstacle = obstacles_[o];
  const Motion<dim>& motion = obstacle.motion();
  const bool moves = motion.moves();
  const int name_of_o = walls() + o, name_of_b = first_body() + b;
  const Field body_x = of_body(x, b);
  Pressing own{.body = b, .boundary = boundaries_[b], .x = body_x};
  for (Eigen::Index v = 0; moves && v < own.x.cols(); ++v) {
    const Vec<dim> home = motion.origin(body_x.col(v), t);
    for (int k = 0; k < dim; ++k) own.x(k, v) = home[k];
  }
  const std::size_t first = touches.size();
  press(own,
        {.body = -1,
         .boundary = obstacle.boundary(),
         .search = obstacle.search(),
         .rest_gap = rest_gaps(name_of_b, name_of_o)},
        widened(obstacle.shape().bounds()), touches);
  for (std::size_t k = first; k < touches.size(); ++k) {
    Touch<dim>& touch = touches[k];
    touch.other = name_of_o;
    if (!moves) continue;
    const Vec<dim> home = touch.place;
    touch.place = motion.place(home, t);
    touch.normal = motion.place(home + touch.normal, t) - touch.place;
    touch.prescribed_rate = -touch.normal.dot(motion.velocity(home, t));
  }
  Pressing others{.body = -1, .boundary = obstacle.boundary(), .x = obstacle.boundary().position};
  for (Eigen::Index v = 0; moves && v < others.x.cols(); ++v) {
    const Vec<dim> now = motion.place(obstacle.boundary().position.col(v), t);
    for (int k = 0; k < dim; ++k) others.x(k, v) = now[k];
  }
  const Box<dim> region = widened(box_of<dim>(body_x));
  const FacetSearch<dim> search(boundaries_[b], body_x, reach_, widened(obstacle.box(t)));
  const std::size_t second = touches.size();
  press(
      others,
      {.body = b, .boundary = boundaries_[b], .search = search, .rest_gap = rest_gaps(name_of_o, name_of_b)},
      region, touches);
  for (std::size_t k = second; k < touches.size(); ++k) {
    touches[k].other = name_of_o;
    if (moves)
      touches[k].prescribed_rate =
          touches[k].normal.dot(motion.velocity(motion.origin(touches[k].place, t), t));
  }
}

template <int dim>
void Neighborhood<dim>::add_bodies(int a, int b, const Field& x, Touches& touches) const {
  const Field of_a = of_body(x, a), of_b = of_body(x, b);
  const Box<dim> around_a = widened(box_of<dim>(of_a)), around_b = widened(box_of<dim>(of_b));
  const FacetSearch<dim> search_a(boundaries_[a], of_a, reach_, around_b);
  const FacetSearch<dim> search_b(boundaries_[b], of_b, reach_, around_a);
  const int name_of_a = first_body() + a, name_of_b = first_body() + b;
  const std::size_t first = touches.size();
  press({.body = a, .boundary = boundaries_[a], .x = of_a},
        {.body = b,
         .boundary = boundaries_[b],
         .search = search_b,
         .rest_gap = rest_gaps(name_of_a, name_of_b)},
        around_b, touches);
  press({.body = b, .boundary = boundaries_[b], .x = of_b},
        {.body = a,
         .boundary = boundaries_[a],
         .search = search_a,
         .rest_gap = rest_gaps(name_of_b, name_of_a)},
        around_a, touches);
  for (std::size_t k = first; k < touches.size(); ++k) {
    touches[k].body = a;
    touches[k].other = name_of_b;
  }
}

template <int dim>
void Neighborhood<dim>::press(const Pressing& pressing, const Pressed& pressed, const Box<dim>& region,
                              Touches& touches) const {
  const bool between_bodies = pressing.body >= 0 && pressed.body >= 0;
  for (Eigen::Index v = 0; v < pressing.x.cols(); ++v) {
    const Vec<dim> x = pressing.x.col(v);
    if (!region.contains(x)) continue;
    const Eigen::Index own = pressing.body < 0 ? -1 : first_[pressing.body] + v;
    if (own >= 0 && held_[own] != 0 && pressed.body < 0) continue;
    const auto nearest = pressed.search.nearest(x);
    if (!nearest) continue;
    Touch<dim> touch = nowhere<dim>(pressing.body < 0 ? pressed.body : pressing.body, 0,
                                    between_bodies ? beside_body : beside_obstacle);
    touch.gap = nearest->gap - pressed.rest_gap[static_cast<std::size_t>(v)];
    touch.normal = nearest->normal;
    touch.place = x;
    touch.area = pressing.boundary.area[static_cast<std::size_t>(v)];
    touch.vertex[dim] = static_cast<int>(own);
    touch.weight[dim] = 1;
    for (std::size_t k = 0; k < dim && pressed.body >= 0; ++k) {
      const int corner = pressed.boundary.facets[static_cast<std::size_t>(nearest->facet)][k];
      touch.vertex[k] = static_cast<int>(first_[pressed.body]) + corner;
      touch.weight[k] = -nearest->share[k];
    }
    if (!all_held(touch)) touches.push_back(touch);
  }
}

template <int dim>
bool Neighborhood<dim>::all_held(const Touch<dim>& touch) const {
  return std::all_of(touch.vertex.begin(), touch.vertex.end(),
                     [&](int v) { return v < 0 || held_[static_cast<std::size_t>(v)] != 0; });
}

template <int dim>
const std::vector<double>& Neighborhood<dim>::rest_gaps(int pressing, int pressed) const {
  const auto boundary = [&](int name) -> const Boundary<dim>& {
    return name < first_body() ? obstacles_[name - walls()].boundary() : boundaries_[name - first_body()];
  };
  const auto [found, is_new] = rest_gaps_.try_emplace({pressing, pressed});
  if (is_new)
    found->second = find_rest_gaps(
        boundary(pressing), boundary(pressed),
        pressed < first_body() ? obstacles_[pressed - walls()].shape() : shapes_[pressed - first_body()]);
  return found->second;
}

/// The gap at which a pair of objects begins to touch [m], if its gap is `at_start` in the undeformed scene.
template <int dim>
double Neighborhood<dim>::rest_gap(double at_start, double play) const {
  if (at_start > touching * spacing_) return 0;
  return std::min(0.0, at_start) - play;
}

/// Rest gaps of the pressing vertices; vertices far inside the body never touch.
template <int dim>
std::vector<double> Neighborhood<dim>::find_rest_gaps(const Boundary<dim>& pressing,
                                                      const Boundary<dim>& pressed,
                                                      const Shape<dim>& shape) const {
  std::vector<double> gaps(pressing.area.size(), 0.0);
  const Box<dim> region = box_of<dim>(pressing.position);
  if (!overlap(region, widened(shape.bounds()))) return gaps;
  const FacetSearch<dim> search(pressed, pressed.position, reach_, region);
  for (std::size_t v = 0; v < gaps.size(); ++v) {
    const Vec<dim> x = pressing.position.col(static_cast<Eigen::Index>(v));
    if (const auto nearest = search.nearest(x))
      gaps[v] = rest_gap(nearest->gap, 0);
    else if (shape.contains(x))
      gaps[v] = -std::numeric_limits<double>::infinity();
  }
  return gaps;
}

template class Neighborhood<2>;
template class Neighborhood<3>;

}  // namespace cosurge::contact
