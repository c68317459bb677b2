#include "coupler/draw/axes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "coupler/draw/colors.hpp"

namespace cosurge {
namespace {

constexpr double letters = 12;
const Color ink = hex(0x4b5563), faint = hex(0x9ca3af);

}  // namespace

std::vector<double> ticks(double low, double high, int most) {
  if (!(high > low)) return {low};
  const double power = std::pow(10, std::floor(std::log10((high - low) / most)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if ((high - low) / (factor * power) <= most) step = factor * power;
  std::vector<double> out;
  for (double n = std::ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; ++n)
    out.push_back(n * step + 0.0);  // no -0
  return out;
}

void draw_axes(Canvas& canvas, const View& view) {
  const Rectangle& area = view.area();
  const Pixel origin = view.pixel({0, 0});
  const auto metres_x = [&](double x) { return (x - origin.x) / view.pixels_a_metre(); };
  const auto metres_y = [&](double y) { return (origin.y - y) / view.pixels_a_metre(); };
  const Pixel corner{area.left, area.bottom()};
  canvas.line({{area.left, area.top},
               corner,
               {area.right(), area.bottom()},
               {area.right(), area.top},
               {area.left, area.top}},
              {.color = faint});
  const auto number = [](double value) { return fmt::format("{:.6g}", value); };
  for (const double x :
       ticks(metres_x(area.left), metres_x(area.right()), std::max(2, static_cast<int>(area.width / 70)))) {
    const double at = view.pixel({x, 0}).x;
    canvas.line({{at, corner.y}, {at, corner.y + 5}}, {.color = faint});
    canvas.text({at, corner.y + 18}, number(x), letters, ink, Align::center);
  }
  for (const double y :
       ticks(metres_y(area.bottom()), metres_y(area.top), std::max(2, static_cast<int>(area.height / 45)))) {
    const double at = view.pixel({0, y}).y;
    canvas.line({{corner.x - 5, at}, {corner.x, at}}, {.color = faint});
    canvas.text({corner.x - 8, at + 4}, number(y), letters, ink, Align::right);
  }
  canvas.text({area.right(), corner.y + 33}, "x [m]", letters, ink, Align::right);
  canvas.text({area.left, area.top - 6}, "y [m]", letters, ink, Align::right);
}

void draw_directions(Canvas& canvas, const View& view) {
  constexpr double length = 42;
  const Rectangle& area = view.area();
  const Pixel corner{area.left + 46, area.bottom() - 30};
  const Pixel zero = view.pixel({0, 0, 0});
  const std::vector<std::pair<std::string, Place>> axes = {
      {"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}};
  for (const auto& [name, axis] : axes) {
    const Pixel tip = view.pixel(axis);
    const double factor = length / view.pixels_a_metre();
    const Pixel end{corner.x + factor * (tip.x - zero.x), corner.y + factor * (tip.y - zero.y)};
    canvas.line({corner, end}, {.color = ink, .width = 1.5});
    canvas.text({corner.x + 1.25 * (end.x - corner.x), corner.y + 1.25 * (end.y - corner.y) + 4}, name,
                letters, ink, Align::center);
  }
}

}  // namespace cosurge
