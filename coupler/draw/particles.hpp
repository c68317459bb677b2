// Clouds of particles in a picture.
#pragma once

#include "coupler/draw/view.hpp"

namespace cosurge {

/// Particles of one spacing. Those at places that are not finite are not drawn.
struct Cloud {
  double spacing = 0;            ///< [m]
  std::vector<float> positions;  ///< [m], one particle after the other
  std::vector<Color> colors;     ///< one a particle
};

/// Two dimensions: squares of one spacing, which touch. Three: balls, the nearer ones before the others.
void draw_particles(Canvas& canvas, const View& view, const std::vector<Cloud>& clouds);

}  // namespace cosurge
