// What a run says of its progress, as one line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace cosurge {

/// How far a run is, and the values that are shown while it goes.
struct ProgressState {
  double time = 0;                ///< reached [s]
  double end = 0;                 ///< end of the case [s]
  std::uint64_t window = 0;       ///< number of windows so far
  double window_size = 0;         ///< size of the last window [s]
  double seconds = 0;             ///< since the start or the resumption [s]
  double seconds_per_window = 0;  ///< mean over the windows since the last state [s]
  double seconds_left = 0;        ///< expected [s]
  std::string probe;              ///< "tip 12.3 mm": the first probe of the case; empty: it has none
  double max_speed = 0;           ///< largest speed of the water [m/s]; NaN without water
  double iterations = 1;          ///< iterations in the last window
  double unconverged = 0;         ///< windows so far that did not converge
  double added_mass_ratio = 0;    ///< estimate [-]
};

/// One line of at most `width` columns. Less important values are left out where they do not fit: the time
/// and the time left come first, then the probe, the coupling, the speed of the computation.
/// The added-mass ratio is shown from 0.1 on: below, no coupling scheme is near its limit.
std::string progress_line(const ProgressState& state, std::size_t width);

/// A value with its unit, in mm for lengths below a metre and in thousands (kPa, kN) from 10 000 on.
std::string with_unit(double value, const std::string& unit);

/// "1:23" or "2:03:04".
std::string clock_text(double seconds);

}  // namespace cosurge
