// The semi-implicit MPS step.
#pragma once

#include <memory>
#include <string>

#include "common/phase_clock.hpp"
#include "fluid_solver/added_mass.hpp"
#include "fluid_solver/bodies.hpp"
#include "fluid_solver/collision.hpp"
#include "fluid_solver/covered_faces.hpp"
#include "fluid_solver/covered_walls.hpp"
#include "fluid_solver/density.hpp"
#include "fluid_solver/direct_force.hpp"
#include "fluid_solver/film_pressure.hpp"
#include "fluid_solver/pressure/poisson_equation.hpp"
#include "fluid_solver/pressure/source.hpp"
#include "fluid_solver/walls.hpp"

namespace cosurge::fluid {

/// Phases of a step whose wall time is added up.
enum Phase : std::size_t { predicting, searching, evaluating, assembling, solving, correcting, phase_count };

/// Report of one step.
struct StepReport {
  SolveReport pressure;
  double max_speed = 0;   ///< largest speed of a fluid particle [m/s]
  double max_window = 0;  ///< largest next step [s]: eq. (17)
};

/// The water of a run: its particles, its walls and the bodies in it, and the step of the semi-implicit MPS
/// method (docs/method.md, section 1).
template <int dim>
class Mps {
 public:
  /// Lays out water, walls and the bodies' points at rest.
  Mps(const Water<dim>& water, const std::vector<WetBody<dim>>& bodies);

  /// One step of `dt` [s] with the bodies where move_bodies() put them. `attempt` as in Window: a step that
  /// is repeated starts from the predicted state that the first attempt left, with the same neighbours, free
  /// surface and matrix, and with the velocity of the bodies as it is now.
  /// @throws NumericalError when the pressure does not converge, a particle leaves all physical bounds, or
  /// the water collapses; the message names time, particle, cause and remedy.
  StepReport step(double start, double dt, Attempt attempt = Attempt::once);

  /// Puts the bodies' points to their displaced positions; both dimension x points [m], [m/s].
  void move_bodies(const Field& displacement, const Field& velocity);

  /// Gives the bodies' points another velocity where they are [m/s].
  void set_body_velocity(const Field& velocity);

  /// Modes of the structure that respond to the load of the next step (AddedMass).
  void set_modes(const std::vector<Mode>& modes) { added_mass_.set_modes(modes); }

  /// Sets the angular frequency [rad/s] of the structure's slowest oscillation, which determines k_b of eq.
  /// (6d).
  void set_frequency(double frequency) { frequency_ = frequency; }

  const AddedMass<dim>& added_mass() const { return added_mass_; }

  /// Load on the bodies' points by eq. (15), and the pressure on their faces. Fills force [N] and pressure
  /// [Pa].
  void load(InterfaceLoad& load) const;

  /// Pressure gradient between the centre of a wet particle and its face at rest [Pa/m]: rho g, eq. (15).
  /// Zero with flagged free surfaces: there the computed surface lies half a spacing too low, which has the
  /// opposite effect.
  Vec<dim> slope_to_faces() const;

  /// theta of eq. (15) for a particle of a wall or body with the pressure p [Pa]: from 0 at p = 0 to 1 at the
  /// pressure of half a spacing of water.
  double wetness(double p) const;

  /// Friction and collisions of the last step on the particle of a wall or body at `place` [N].
  Vec<dim> direct_force(int place) const { return direct_force_.on(place); }

  const Walls<dim>& walls() const { return walls_; }
  const Bodies<dim>& bodies() const { return bodies_; }
  const Particles<dim>& particles() const { return particles_; }
  /// Longest first step [s]: eq. (17) for water at rest and walls that move from the start.
  double first_window(double longest) const;

  int initial_size() const { return initial_size_; }
  const Neighbors<dim>& neighbors() const { return neighbors_; }
  double n0() const { return reference_.n0; }
  double spacing() const { return water_.spacing; }
  const PhaseClock<phase_count>& clock() const { return clock_; }
  int unknowns() const { return poisson_.matrix().size(); }
  std::int64_t matrix_entries() const { return poisson_.matrix().entries(); }

  std::string save() const;
  void restore(const std::string& state);

 private:
  template <typename Self, typename Visit>
  static void each_field(Self& self, Visit&& visit);
  void add_water(const std::vector<WetBody<dim>>& bodies);
  void advance_to_pressure(double start, double dt);
  void return_to_pressure();
  void predict(double start, double dt);
  void search_neighbors(double time);
  void locate_bodies();
  void close_covered_faces();
  void check_state() const;
  void diffuse_and_collide(double dt);
  void find_free_surface();
  void find_driven_speed(double end, double dt);
  void set_source(double dt);
  void assemble(double dt);
  /// Whether missing neighbours count as air (pressure/open_surface.hpp) instead of flags on particles.
  bool open_surface() const { return water_.method.source == Source::time_scale; }
  /// Whether anything can cover a wall.
  bool may_cover() const { return bodies_.points() > 0 || walls_.moves(); }
  double restitution() const;
  double near_deviation(int i) const;
  double unbiased_deviation(int i, double smooth) const;
  Rates rates(double dt) const;
  double response_time(double dt) const;
  void set_source_per_divergence(double dt);
  Field body_change() const;
  void add_source_of_bodies(double dt);
  /// rho k_b of eq. (6d), the least change of the source per divergence of a change of the bodies' velocity
  /// [kg/(m3 s)]; 0 without an open surface.
  double least_per_change(double dt) const;
  BodiesInWater<dim> bodies_in_water() const {
    return {particles_, neighbors_, reference_, poisson_, seen_, covers_, body_place_};
  }
  void take_pressure();
  void set_face_load();
  void add_answer_of_modes();
  SolveReport solve_pressure(double start, double dt, Attempt attempt);
  Vec<dim> pressure_gradient(int i) const;
  void correct(double dt);
  void shift(double dt);
  StepReport survey(double end, double dt);
  double courant(double driven) const;
  double approach_to_faces(double least) const;
  double longest_step(double speed, double driven) const;
  void check_bounds(int water, int which, double fastest, double end) const;

  Water<dim> water_;
  ReferenceValues reference_;  // values for the radius re_gradient
  Walls<dim> walls_;
  Bodies<dim> bodies_;
  CoveredFaces<dim> covered_faces_;
  FilmPressure<dim> film_pressure_;
  DirectForce<dim> direct_force_;
  Particles<dim> particles_;
  int initial_size_ = 0;
  Neighbors<dim> neighbors_;
  PoissonEquation<dim> poisson_;
  std::unique_ptr<Preconditioner> preconditioner_;
  AddedMass<dim> added_mass_;
  PhaseClock<phase_count> clock_;

  Vec<dim> nowhere_;  // outside the domain; particles that have passed through a wall are moved there
  double propagation_speed_ = 0;  // c of the source `time_scale` [m/s]
  double speed_bound_ = 0;        // [m/s]
  double max_body_speed_ = 0;
  double driven_speed_ = 0;  // V of eq. (6c): speed of obstacles and bodies towards the water [m/s]
  double frequency_ = 0;     // omega of eq. (6d), of the structure's oscillation [rad/s]
  int first_body_id_ = 0;
  Faces<dim> faces_;                      // deformed faces of the bodies, by point
  std::vector<Vec<dim>> face_load_;       // load in addition to -P A on the bodies' points [N]
  std::vector<std::int32_t> body_place_;  // particle index for each body point
  std::vector<int> seen_;                 // index of the point whose velocity a body point has for the water
  std::vector<Cover> covers_;             // covered walls, by place
  std::vector<Vec<dim>> areas_;           // A by place, for the pressure equation
  std::vector<double> smooth_density_;    // s' of eq. (2c), by place [-]; empty without an open surface
  std::vector<Vec<dim>> change_;          // velocity change since the prediction, by place
  std::vector<Vec<dim>> push_;            // velocity change by the pressure, by place
  std::vector<double> source_;            // source of the pressure equation, by place
  std::vector<double> source_per_divergence_;  // change of the source per divergence, by place [kg/(m3 s)]
  Field last_body_velocity_;                   // velocity of the body points in the last window [m/s]
  std::vector<double> pressure_;               // pressure of the unknowns
  std::vector<Vec<dim>> predicted_x_;          // predicted positions of a step that may be repeated, by place
  std::vector<Vec<dim>> predicted_u_;
};

}  // namespace cosurge::fluid
