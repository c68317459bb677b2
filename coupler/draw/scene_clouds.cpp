#include "coupler/draw/scene_clouds.hpp"

#include <cmath>

#include "coupler/draw/colors.hpp"

namespace cosurge {
namespace {

constexpr int last_shown = 2;  // kind of dummies

}  // namespace

Color wall_color(Kind kind) { return kind == Kind::wall ? hex(0xb4bac4) : hex(0xdde1e7); }

ShownFrame read_shown(const FrameSource& source, const Cast& cast, std::size_t frame,
                      const std::string& quantity) {
  const std::vector<float> position = source.read("position", frame);
  const std::vector<float> kind =
      cast.member == "fluid" && source.has("kind") ? source.read("kind", frame) : std::vector<float>();
  const auto dimension = static_cast<std::size_t>(source.components("position"));
  std::vector<float> values;
  if (quantity == "speed")
    values = source.read("velocity", frame);
  else if (!quantity.empty())
    values = source.read(quantity, frame);
  ShownFrame shown;
  for (const std::size_t k : cast.particles) {
    const int is = kind.empty() ? 0 : static_cast<int>(kind[k]);
    if (is > last_shown) continue;
    shown.kinds.push_back(static_cast<Kind>(is));
    const auto at = position.begin() + static_cast<std::ptrdiff_t>(k * dimension);
    shown.positions.insert(shown.positions.end(), at, at + static_cast<std::ptrdiff_t>(dimension));
    if (quantity.empty()) continue;
    float square = 0;
    for (std::size_t axis = 0; axis < dimension && quantity == "speed"; ++axis)
      square += values[k * dimension + axis] * values[k * dimension + axis];
    shown.values.push_back(quantity == "speed" ? std::sqrt(square) : values[k]);
  }
  return shown;
}

}  // namespace cosurge
