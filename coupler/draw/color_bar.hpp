// The colour scale of a quantity beside a picture.
#pragma once

#include "coupler/draw/colors.hpp"

namespace cosurge {

/// A quantity that particles are coloured by.
struct Shade {
  std::string name;  ///< "pressure"
  std::string unit;
  const Scale* scale = nullptr;
  double low = 0;
  double high = 1;

  Color color(double value) const { return color_of(*scale, value, low, high); }
};

/// A level bar with the name, the unit and the numbers at both ends. `label`: what is coloured, "water".
void draw_color_bar(Canvas& canvas, const Shade& shade, const std::string& label, const Rectangle& area);

}  // namespace cosurge
