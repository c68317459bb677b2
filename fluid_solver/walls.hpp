// The walls: tank and obstacles, at rest or in a prescribed motion.
#pragma once

#include "common/geometry/motion.hpp"
#include "common/geometry/shape.hpp"
#include "fluid_solver/particles.hpp"
#include "fluid_solver/point_hash.hpp"
#include "fluid_solver/water.hpp"

namespace cosurge::fluid {

/// A particle of a wall's first layer.
template <int dim>
struct WallParticle {
  std::int32_t id;
  Vec<dim> place;  ///< initial position [m]
};

/// The walls of a scene. Its parts are numbered, 0 for the tank and then the obstacles; each part moves as
/// one rigid body.
template <int dim>
class Walls {
 public:
  /// Places the wall particles. The tank has a floor and side walls with filled corners, of one layer with
  /// pressure and `dummy_layers` layers behind it, and is open at the top (the last coordinate). The
  /// outermost layer of obstacles has pressure; obstacles with an outline have layers parallel to it
  /// (docs/method.md, Walls). Obstacles may overlap each other and the tank's walls: a site in several
  /// belongs to the tank, or else to the first obstacle. Obstacles move with the tank or by their own motion;
  /// an obstacle with its own motion has no particles where it overlaps the tank's walls at the start.
  /// @param slip whether particles have the normals of their faces, along which water slides; else zero
  Walls(const Water<dim>& water, int dummy_layers, bool slip = true);

  /// Adds all wall and dummy particles.
  void add_to(Particles<dim>& particles);

  /// Whether an obstacle takes this place at the start.
  bool covers(const Vec<dim>& x) const;

  /// Region in which particles may be: tank, walls and obstacles in all positions of their motion, with a
  /// margin, and above the tank's open top once more its height.
  Box<dim> domain() const;

  const Box<dim>& tank() const { return tank_; }
  const Shape<dim>& obstacle(int number) const { return obstacles_[static_cast<std::size_t>(number)]; }
  const Motion<dim>& motion(std::size_t part) const { return parts_[part].motion; }

  /// The particles with pressure of a part, once add_to() has given them ids.
  std::vector<WallParticle<dim>> sites(std::size_t part) const;

  /// Whether x lies in the floor or side walls, or in an obstacle, at time t [s]; the part itself does not
  /// count.
  bool inside_other(std::size_t part, const Vec<dim>& x, double t) const;

  /// Whether the wall particle with this id is the tank's.
  bool of_tank(std::int32_t id) const { return part_of(id) == 0; }

  /// Whether the wall particle with this id belongs to an obstacle that does not move with the tank.
  bool moves_in_tank(std::int32_t id) const;

  /// Whether the tank or an obstacle moves.
  bool moves() const;

  /// Moves the walls with a motion to their position at time `end` [s], with their mean velocity over the
  /// last `dt` [s]. Wall particles that were covered become wall particles again.
  void move(Particles<dim>& particles, double end, double dt);

  /// @throws NumericalError where an obstacle has moved into floor, side walls or another obstacle by time
  /// `t` [s].
  void require_room(double t) const;

  /// Largest speed of a wall in the last move [m/s].
  double speed() const { return speed_; }

  /// Largest speed of an obstacle against the tank in the last move [m/s].
  double approach() const { return approach_; }

  /// Mean velocity over the last move, of `dt` [s], of the point of the tank's frame that is at x at time
  /// `end` [m/s].
  Vec<dim> tank_velocity(const Vec<dim>& x, double end, double dt) const {
    return (x - tank_motion_.place(tank_motion_.origin(x, end), end - dt)) / dt;
  }

  /// Largest mean speed of any point of a wall between the times `from` < `to` [s], in [m/s].
  double speed_between(double from, double to) const;

  /// Whether x at time t has left the tank by more than a spacing, through floor or sides.
  bool outside(const Vec<dim>& x, double t) const;

 private:
  /// A tank or obstacle that moves as one.
  struct Part {
    std::vector<Vec<dim>> place;   // initial positions of its particles
    std::vector<Vec<dim>> normal;  // initial normals of the faces before them, towards the water
    std::vector<Kind> kind;
    Motion<dim> motion;
    bool with_tank = true;  // it moves as the tank does
    std::int32_t first_id = 0;
  };

  std::size_t part_of(std::int32_t id) const;
  bool taken(const Vec<dim>& x, bool moves) const;
  double depth_in_walls(const Vec<dim>& x) const;
  void require_room(std::ptrdiff_t obstacle, const Vec<dim>& x, double t) const;
  Vec<dim> tank_normal(const Vec<dim>& x) const;
  Part tank_part() const;
  Part obstacle_part(const Obstacle<dim>& obstacle) const;
  PointHash<dim> particles_near(const Box<dim>& box) const;

  Box<dim> tank_;
  double spacing_;
  int dummy_layers_;
  double thickness_;  // thickness of the tank's walls [m]
  std::vector<Shape<dim>> obstacles_;
  Motion<dim> tank_motion_;
  std::vector<Part> parts_;
  double speed_ = 0;
  double approach_ = 0;
};

}  // namespace cosurge::fluid
