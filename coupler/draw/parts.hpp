// The parts of a case in a picture: tank, water, bodies, clamps, supports, probes, paths of walls.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "coupler/draw/view.hpp"

namespace cosurge {

/// A part of a case, as report/outlines.hpp describes it.
struct Part {
  std::string kind;   ///< "tank"
  std::string label;  ///< "obstacle 1"
  std::vector<std::vector<Place>> lines;
  std::vector<std::vector<double>> poses;  ///< one an instant, for parts that move
};

/// How parts of a kind are drawn.
struct PartStyle {
  std::string name;  ///< name in the legend
  Stroke stroke;
  bool hatched = false;
};

std::vector<Part> read_parts(const nlohmann::ordered_json& outlines);

/// Style of a kind; kinds that are not known are drawn as obstacles.
const PartStyle& style_of(const std::string& kind);

/// Draws lines, or the point of a probe, where they are at the instant `pose` of its poses.
void draw_part(Canvas& canvas, const View& view, const Part& part, std::size_t pose = 0);

/// Swatches and names of the kinds among the parts, in rows from `top` downwards. Returns the lower end.
double draw_legend(Canvas& canvas, const std::vector<Part>& parts, const Rectangle& area);

}  // namespace cosurge
