#include "coupler/draw/color_bar.hpp"

#include <fmt/format.h>

namespace cosurge {

void draw_color_bar(Canvas& canvas, const Shade& shade, const std::string& label, const Rectangle& area) {
  constexpr double letters = 12;
  const Color ink = hex(0x374151);
  const int steps = static_cast<int>(area.width);
  for (int k = 0; k < steps; ++k)
    canvas.fill(Rectangle{area.left + k, area.top, 1.5, area.height},
                color_of(*shade.scale, k, 0, std::max(1, steps - 1)));
  canvas.text({area.left, area.top - 5}, fmt::format("{}: {} [{}]", label, shade.name, shade.unit), letters,
              ink);
  canvas.text({area.left, area.bottom() + 14}, fmt::format("{:.4g}", shade.low), letters, ink);
  canvas.text({area.right(), area.bottom() + 14}, fmt::format("{:.4g}", shade.high), letters, ink,
              Align::right);
}

}  // namespace cosurge
