// Measurements in the water in every window.
#pragma once

#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

/// Pressure at a point of a body's wet surface: linear interpolation along the face between the centres of
/// the surface particles next to it in the reference configuration.
template <int dim>
class SurfacePressureProbe {
 public:
  /// @throws Error when no wet face lies within a spacing of `position` [m].
  SurfacePressureProbe(const std::string& name, const Vec<dim>& position, const Interface& interface,
                       double spacing);

  /// [Pa], from the pressure at each interface point.
  double read(const Eigen::VectorXd& pressure) const;

 private:
  std::vector<std::pair<Eigen::Index, double>> weights_;
};

/// Pressure at a fixed point of the water or a wall [Pa]: the value there of the linear function that fits
/// the particles with pressure within r_e best, weights (1 - r / r_e)^2; 0 in the dry.
template <int dim>
double pressure_at(const Mps<dim>& mps, const Vec<dim>& x);

/// Energies and extent of the water at one instant.
struct WaterState {
  double kinetic_energy = 0;  ///< [J] (per metre of width in two dimensions)
  double gravity_energy = 0;  ///< [J], zero at the origin
  double front = 0;           ///< largest first coordinate of water that touches other water [m]
  int inside_bodies = 0;      ///< fluid particles closer than half a spacing to an inner point of a body
};

/// The state of the water. `particle_mass` [kg], per metre of width in two dimensions; `spacing` [m];
/// `gravity` [m/s2].
template <int dim>
WaterState survey_water(const Mps<dim>& mps, double particle_mass, double spacing, const Vec<dim>& gravity);

}  // namespace cosurge::fluid
