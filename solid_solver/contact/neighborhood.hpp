// Objects that bodies can touch, and where they are near them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "solid_solver/contact/obstacle_boundary.hpp"
#include "solid_solver/contact/tank_walls.hpp"
#include "solid_solver/contact/touch.hpp"
#include "solid_solver/scene.hpp"

namespace cosurge::contact {

/// Finds contacts with the floor and the walls of the tank, with obstacles at rest or in motion, and between
/// bodies (docs/method_solid.md, section 12). Vertices of a body are tested against walls and against the
/// facets of other objects; vertices of obstacles and other bodies are tested against its facets, so that no
/// corner is missed. Gaps that are negative at the start are measured from there. Objects that touch at the
/// start may approach by a small share of the spacing before they touch if the bodies have clamps or
/// supports.
template <int dim>
class Neighborhood {
 public:
  using Touches = std::vector<Touch<dim>>;

  /// Facets have edges of at most the spacing of the structure.
  Neighborhood(const Structure<dim>& structure, const Surroundings<dim>& surroundings);

  int bodies() const { return static_cast<int>(boundaries_.size()); }
  /// Vertices of all bodies, body after body, undeformed [m].
  const Field& vertices() const { return reference_; }
  const std::vector<int>& body() const { return body_; }     ///< body of each vertex
  const std::vector<double>& area() const { return area_; }  ///< area of each vertex [m^(dim-1)]

  /// Sets which vertices are held by their bodies and have no contact; by default none.
  void hold(std::vector<char> held) { held_ = std::move(held); }

  bool held(Eigen::Index vertex) const { return held_[static_cast<std::size_t>(vertex)] != 0; }

  /// Distance beyond which objects do not touch, and largest depth at which contact is found [m].
  double reach() const { return reach_; }

  /// All pairs of a vertex and a facet or wall with a gap below the reach. Their order depends on the
  /// positions only.
  /// @param x of the vertices at time t [m]
  Touches within_reach(const Field& x, double t) const;

  /// "the floor of the tank", "fluid.obstacle.0", "solid.body.1"
  std::string name(int other) const;

  /// The body that `other` is, or -1.
  int body_of(int other) const { return other < first_body() ? -1 : other - first_body(); }

 private:
  /// Vertices that are tested, in the frame of the facets.
  struct Pressing {
    int body;  // -1: an obstacle
    const Boundary<dim>& boundary;
    Field x;
  };
  /// Facets against which vertices are tested.
  struct Pressed {
    int body;  // -1: an obstacle
    const Boundary<dim>& boundary;
    const FacetSearch<dim>& search;
    const std::vector<double>& rest_gap;  // initial gap of each pressing vertex
  };

  int walls() const { return tank_.empty() ? 0 : TankWalls<dim>::count; }
  int first_body() const { return walls() + static_cast<int>(obstacles_.size()); }
  Field of_body(const Field& all, int b) const;
  Box<dim> widened(const Box<dim>& box) const;
  double rest_gap(double at_start, double play) const;
  const std::vector<double>& rest_gaps(int pressing, int pressed) const;
  std::vector<double> find_rest_gaps(const Boundary<dim>& pressing, const Boundary<dim>& pressed,
                                     const Shape<dim>& shape) const;

  void add_walls(const Field& x, double t, Touches& touches) const;
  void add_obstacle(int o, int b, const Field& x, double t, Touches& touches) const;
  void add_bodies(int a, int b, const Field& x, Touches& touches) const;
  void press(const Pressing& pressing, const Pressed& pressed, const Box<dim>& region,
             Touches& touches) const;
  bool all_held(const Touch<dim>& touch) const;

  double spacing_, reach_;
  std::vector<TankWalls<dim>> tank_;  // empty without water
  std::vector<ObstacleBoundary<dim>> obstacles_;
  std::vector<Shape<dim>> shapes_;  // shape of each body
  std::vector<char> clamped_;       // whether clamps or supports hold each body
  std::vector<Boundary<dim>> boundaries_;
  std::vector<Eigen::Index> first_;  // first vertex of each body, and the number of vertices
  Field reference_;
  std::vector<int> body_;
  std::vector<double> area_;
  std::vector<char> held_;
  mutable std::map<std::pair<int, int>, std::vector<double>> rest_gaps_;  // by name: pressing, pressed
};

/// d gap / dt [m/s] if the vertices move with the velocities v, dimension x vertices [m/s].
template <int dim>
double rate(const Touch<dim>& touch, const Field& v) {
  double sum = touch.prescribed_rate;
  for (std::size_t k = 0; k < touch.vertex.size(); ++k)
    if (touch.vertex[k] >= 0) sum += touch.weight[k] * touch.normal.dot(v.col(touch.vertex[k]));
  return sum;
}

}  // namespace cosurge::contact
