// The water that the fluid solver computes, and what is in it.
#pragma once

#include <optional>
#include <vector>

#include "common/geometry/tank.hpp"
#include "fluid_solver/pressure/pressure_solution.hpp"

namespace cosurge::fluid {

/// Source term of the pressure equation.
enum class Source {
  deviation,   ///< deviation of the number density from its reference (Amaro & Cheng)
  mixed,       ///< velocity divergence plus gamma times the deviation
  time_scale,  ///< as mixed, but on the time scale l0 / propagation speed instead of dt
};

/// Pressure gradient.
enum class Gradient {
  p_min,       ///< relative to the smallest pressure of the neighbours, purely repulsive (Amaro & Cheng)
  conserving,  ///< equal and opposite in every pair; conserves momentum
  corrected,   ///< exact for a linear pressure, with a repulsion of unevenly distributed particles
};

/// Flags of the free surface, with the sources `deviation` and `mixed`.
struct FreeSurface {
  double beta;   ///< flagged where n < beta n0 ...
  double delta;  ///< ... and the centroid of the neighbours is farther away [l0]
};

/// Collisions of particles, eq. (7).
struct Collision {
  double distance;                    ///< particles that are closer and approach each other collide [l0]
  std::optional<double> restitution;  ///< coefficient; otherwise that of the surface's treatment
};

/// How the water is computed (docs/method.md, section 1).
struct Method {
  Source source;
  Gradient gradient;
  double gamma;                             ///< share of the density deviation that is corrected in a step
  std::optional<double> propagation_speed;  ///< with `time_scale` [m/s]; otherwise sqrt(g H)
  double re_gradient;                       ///< effective radius of all sums except the next [l0]
  double re_laplacian;                      ///< effective radius of the Laplacian of the pressure [l0]
  double courant;                           ///< Courant number that limits windows
  double courant_driven;                    ///< the same while walls drive the water
  double shifting;                          ///< share of a spacing per step at a Courant number of 1; 0: none
  double lowest_pressure;                   ///< [Pa]
  FreeSurface free_surface;
  Collision collision;
  PressureSolution pressure;
};

/// The water of a case, with its tank and obstacles.
template <int dim>
struct Water {
  double spacing;              ///< particle spacing l0 [m]
  double density;              ///< rho [kg/m3]
  double kinematic_viscosity;  ///< [m2/s]
  double compressibility;      ///< alpha [1/Pa]
  Vec<dim> gravity;            ///< [m/s2]
  Tank<dim> tank;
  std::vector<Obstacle<dim>> obstacles;
  std::vector<Shape<dim>> regions;  ///< regions of water at the start, at rest
  double most_lost;                 ///< largest share of the water that may leave the tank
  Method method;
};

/// A body of the structure as the water meets it.
template <int dim>
struct WetBody {
  Shape<dim> shape;                ///< undeformed
  std::vector<Shape<dim>> clamps;  ///< regions in which the body is extended and fixed
  bool held_at_rest = false;       ///< whether it is held by something that does not move in the tank
};

}  // namespace cosurge::fluid
