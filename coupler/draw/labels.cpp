#include "coupler/draw/labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cosurge {
namespace {

constexpr double letters = 13, height = 17, radius = 7;

}  // namespace

void Labels::avoid(const Pixel& point) {
  taken_.push_back({point.x - radius, point.y - radius, 2 * radius, 2 * radius});
}

bool Labels::is_free(const Rectangle& box) const {
  return area_.contains({box.left, box.top}) && area_.contains({box.right(), box.bottom()}) &&
         std::none_of(taken_.begin(), taken_.end(),
                      [&](const Rectangle& other) { return box.overlaps(other); });
}

void Labels::put(const Pixel& point, const std::string& name, const Color& color) {
  const double width = canvas_.text_width(name, letters) + 6;
  constexpr int directions = 16, rings = 8;
  Rectangle box{point.x + radius, point.y - height / 2, width, height};
  for (int k = 0; k < directions * rings && !is_free(box); ++k) {
    const double angle = 2 * std::numbers::pi * (k % directions) / directions;
    const double distance = radius + 4 + 16 * (k / directions);  // NOLINT(bugprone-integer-division)
    const Pixel near{point.x + distance * std::cos(angle), point.y - distance * std::sin(angle)};
    box.left = std::cos(angle) > 0.3 ? near.x : std::cos(angle) < -0.3 ? near.x - width : near.x - width / 2;
    box.top = near.y - height / 2;
  }
  taken_.push_back(box);
  const Pixel end{std::clamp(point.x, box.left, box.right()), std::clamp(point.y, box.top, box.bottom())};
  if (std::hypot(end.x - point.x, end.y - point.y) > radius + 8)
    canvas_.line({point, end}, {.color = {color.red, color.green, color.blue, 0.6}});
  canvas_.fill(box, {1, 1, 1, 0.85});
  canvas_.text({box.left + 3, box.top + 13}, name, letters, color);
}

}  // namespace cosurge
