// The particles of a case in a picture.
#pragma once

#include "coupler/draw/particles.hpp"
#include "coupler/report/scene.hpp"

namespace cosurge {

/// Kinds of the fluid's particles in the frames, as far as pictures tell them apart.
enum class Kind { water = 0, wall = 1, dummy = 2 };

/// The shown particles of one solver at one frame; of the fluid water, walls and dummies.
struct ShownFrame {
  std::vector<float> positions;
  std::vector<Kind> kinds;    ///< kind of each particle; those of the structure are all `water`
  std::vector<float> values;  ///< value of the quantity for each particle, if one was requested
};

/// Reads a frame of the particles of `cast`, without those that are lost. `quantity`: the name of an array,
/// "speed", or empty.
ShownFrame read_shown(const FrameSource& source, const Cast& cast, std::size_t frame,
                      const std::string& quantity = "");

/// The colour of walls, lighter for dummies.
Color wall_color(Kind kind);

}  // namespace cosurge
