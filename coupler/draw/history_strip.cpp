#include "coupler/draw/history_strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "coupler/draw/axes.hpp"
#include "coupler/draw/colors.hpp"

namespace cosurge {
namespace {

constexpr double letters = 12;
const Color ink = hex(0x374151), faint = hex(0xd1d5db);
const std::array<Color, 3> curve_colors = {hex(0x1d4ed8), hex(0xd1495b), hex(0x1b998b)};

/// The smallest and the largest value in each column of pixels; the curve through them looks like the
/// complete one.
std::vector<Pixel> thinned(const std::vector<Pixel>& curve) {
  std::vector<Pixel> kept;
  for (std::size_t k = 0; k < curve.size();) {
    std::size_t least = k, most = k, next = k;
    for (; next < curve.size() && std::floor(curve[next].x) == std::floor(curve[k].x); ++next) {
      if (curve[next].y < curve[least].y) least = next;
      if (curve[next].y > curve[most].y) most = next;
    }
    kept.push_back(curve[std::min(least, most)]);
    if (least != most) kept.push_back(curve[std::max(least, most)]);
    k = next;
  }
  return kept;
}

}  // namespace

HistoryStrip::HistoryStrip(const std::vector<double>& time, const std::vector<Series>& columns, double end,
                           const Rectangle& area)
    : area_(area),
      end_(end),
      low_(std::numeric_limits<double>::infinity()),
      high_(-std::numeric_limits<double>::infinity()),
      unit_(columns.front().unit) {
  for (const Series& column : columns)
    for (const double value : column.values)
      if (std::isfinite(value)) low_ = std::min(low_, value), high_ = std::max(high_, value);
  if (!(low_ < high_)) low_ = std::isfinite(low_) ? low_ - 1 : 0, high_ = low_ + 2;
  for (const Series& column : columns) {
    std::vector<Pixel> curve;
    for (std::size_t k = 0; k < std::min(time.size(), column.values.size()); ++k)
      if (std::isfinite(column.values[k])) curve.push_back(pixel(time[k], column.values[k]));
    curves_.push_back(thinned(curve));
    names_.push_back(column.name.substr(column.name.find('/') + 1));
  }
}

Pixel HistoryStrip::pixel(double time, double value) const {
  return {area_.left + area_.width * time / end_,
          area_.bottom() - area_.height * (value - low_) / (high_ - low_)};
}

void HistoryStrip::draw(Canvas& canvas, double time) const {
  for (const double value : ticks(low_, high_, 4)) {
    const double y = pixel(0, value).y;
    canvas.line({{area_.left, y}, {area_.right(), y}}, {.color = faint});
    canvas.text({area_.left - 6, y + 4}, fmt::format("{:.4g}", value), letters, ink, Align::right);
  }
  for (const double t : ticks(0, end_, 10)) {
    const double x = pixel(t, low_).x;
    canvas.line({{x, area_.bottom()}, {x, area_.bottom() + 4}}, {.color = ink});
    canvas.text({x, area_.bottom() + 17}, fmt::format("{:.4g} s", t), letters, ink, Align::center);
  }
  double x = area_.left;
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const Color color = curve_colors[k % curve_colors.size()];
    canvas.line(curves_[k], {.color = color, .width = 1.3});
    const std::string name = fmt::format("{} [{}]", names_[k], unit_);
    canvas.text({x, area_.top - 7}, name, letters, color);
    x += canvas.text_width(name, letters) + 16;
  }
  const double cursor = pixel(time, low_).x;
  canvas.line({{cursor, area_.top}, {cursor, area_.bottom()}}, {.color = hex(0x111827), .width = 1.5});
}

}  // namespace cosurge
