// The numbers that decide how a case behaves, from the case alone.
#pragma once

#include <optional>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// Masses are per metre of width in two dimensions.
struct BodyNumbers {
  double mass = 0;       ///< density times the volume of its sites, or solid.sprung.mass [kg]
  double displaced = 0;  ///< mass of the water in the same volume [kg]
  double thickness = 0;  ///< shortest side of a box; of a plate with volume and surface of an outline [m]
  double longest = 0;    ///< longest side of its bounds [m]

  /// mu = added mass / mass, an estimate for the water of the start; nothing where no water lies above a
  /// lying body or as high as a standing one:
  ///   lying body     all the water above it moves with it (cases/sprung_piston)
  ///   standing body  water of half the wetted height on each wet side, at least on one (docs/stability.md)
  std::optional<double> added_mass_ratio;
  std::optional<double> deflection;  ///< static_deflection() [m]

  /// Gain of waves through the thickness, mu k t / c_p (docs/stability.md, finer lattices): k = c / l0 with
  /// the source time_scale and 1 / dt with the others, t the thickness, c_p = sqrt(E / rho_s).
  std::optional<double> gain;
};

/// Numbers of the whole scene (docs/speed_accuracy.md, cosurge advise).
struct SceneNumbers {
  double head = 0;                 ///< H, from the lowest to the highest water of the start [m]
  double speed = 0;                ///< V = sqrt(2 g H), of water that has fallen by H [m/s]
  double layers = 0;               ///< H / l0
  double window = 0;               ///< expected_window() [s]
  double courant = 0;              ///< V dt / l0
  std::optional<double> reynolds;  ///< V H / nu; nothing for inviscid water
  std::optional<double> cauchy;    ///< rho V^2 / E; nothing without a modulus
  double response = 0;             ///< 1 / k, response time of the pressure, see `gain` [s]
  std::vector<BodyNumbers> bodies;
  double dry_frequency = 0;  ///< highest frequency in vacuum [Hz]; 0: nothing oscillates

  /// In water, of a single body [Hz]:
  ///   plate, beam, body on one spring   dry frequency / sqrt(1 + mu): the water has the body's shape of
  ///                                     motion (Blevins, Formulas for Natural Frequency and Mode Shape)
  ///   layer on its clamp                x c / (2 pi t), x tan x = 1 / mu, c^2 = M / rho_s: compression of a
  ///   bar
  ///                                     with the water's mass on top (Rao, Mechanical Vibrations), M as in
  ///                                     static_deflection()
  std::optional<double> wet_frequency;

  /// Largest of the bodies' values; nothing where no body has one.
  std::optional<double> largest(std::optional<double> BodyNumbers::*value) const;
};

/// @param the_case a checked case with a fluid and a structure
/// @param dry_frequency in vacuum, as the solid solver states it [Hz]
SceneNumbers scene_numbers(const v1::Case& the_case, double dry_frequency);

}  // namespace cosurge
