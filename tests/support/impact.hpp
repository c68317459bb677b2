// The impact of a dam break on a plate with small displacements.
#pragma once

#include "tests/support/plate.hpp"
#include "tests/support/recorded_pressure.hpp"

namespace cosurge {

/// Pressure on the face of `cases/dam_break_rigid`, by benchmarks/impact.py.
inline constexpr const char* impact_file = COSURGE_SOURCE_DIR "/tests/support/impact.csv";

/// Displacement across of the plate's tip, at the instants of the recording.
struct Impact {
  std::vector<double> times;  ///< [s]
  std::vector<double> tip;    ///< [m]

  double seconds = 0;  ///< CPU time after the model was set up [s]

  double largest() const;                     ///< tip [m]
  double at() const;                          ///< its instant [s]
  double mean() const;                        ///< mean tip displacement [m]
  double apart(const Impact& another) const;  ///< largest difference of the displacement of the tip [m]
};

/// A plate at rest until the recording begins, under its pressure on the left face, linear in time between
/// instants; one window from each to the next.
Impact impact_on(PlateCase plate, const RecordedPressure& pressure);

}  // namespace cosurge
