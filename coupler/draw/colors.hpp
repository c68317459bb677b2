// Colour scales, those of the page (report/page/src/colors.js).
#pragma once

#include <array>

#include "coupler/draw/canvas.hpp"

namespace cosurge {

/// Nine colours at even distances.
using Scale = std::array<Color, 9>;

/// For pressures, speeds and stresses.
extern const Scale viridis, speed_scale, stress_scale;

/// The colour of a value between `low` and `high`; that of the end outside.
Color color_of(const Scale& scale, double value, double low, double high);

/// A colour from 0xRRGGBB.
constexpr Color hex(unsigned rgb, double opacity = 1) {
  return {(rgb >> 16 & 0xffU) / 255.0, (rgb >> 8 & 0xffU) / 255.0, (rgb & 0xffU) / 255.0, opacity};
}

}  // namespace cosurge
