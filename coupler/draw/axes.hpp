// Scales around the picture of a scene in two dimensions.
#pragma once

#include "coupler/draw/view.hpp"

namespace cosurge {

/// Round numbers between two values, `most` of them at most.
std::vector<double> ticks(double low, double high, int most);

/// A frame around the area of the view with ticks and numbers [m] below and on the left.
void draw_axes(Canvas& canvas, const View& view);

/// In three dimensions: the directions x, y and z at the lower left corner of the area.
void draw_directions(Canvas& canvas, const View& view);

}  // namespace cosurge
